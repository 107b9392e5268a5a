# Everything is made here. `make help` lists the targets.
config ?= release
prefix ?= /usr/local

VERSION := $(shell sed -n 's/^\#define LAM_VERSION "\(.*\)"/\1/p' gen/include/lamella/api.h)
ifeq ($(config),release)
  out := build
  opt := -O2 -g -fno-omit-frame-pointer
else ifeq ($(config),debug)
  out := build/debug
  opt := -O0 -g3
else ifeq ($(config),sanitize)
  out := build/sanitize
  opt := -O1 -g -Wno-format-truncation -fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer
else ifeq ($(config),thread)
  out := build/thread
  opt := -O1 -g -fsanitize=thread -fno-omit-frame-pointer
else ifeq ($(config),clang)
  out := build/clang
  opt := -O2 -g -fno-omit-frame-pointer
  CC := clang
else
  $(error config is release, debug, sanitize, thread or clang, not "$(config)")
endif

warn     := -Wall -Wextra -Werror -Wshadow
includes := -Igen -Igen/include -I. -isystem /usr/include/suitesparse
# no contraction of a*b+c: the same result on every processor
CFLAGS_   = -std=c11 -D_GNU_SOURCE -fPIC -fvisibility=hidden -ffp-contract=off $(opt) $(warn) $(includes) -MMD -MP $(CFLAGS)
# CGAL's exact predicates switch the rounding mode
CXXFLAGS_ = -std=c++17 -fPIC -fvisibility=hidden -fvisibility-inlines-hidden -O2 -frounding-math $(warn) $(includes) -MMD -MP $(CXXFLAGS)
libs     := -lamd -lgmp -lyaml -ljansson -lpng -lstdc++ -lm

# Debian packages: to build; for pictures and OpenSCAD; for the tests
packages_build := gcc g++ libc6-dev libsuitesparse-dev libcgal-dev \
                  libyaml-dev libjansson-dev libpng-dev
packages_show  := povray povray-includes
packages_check := $(packages_show) librsvg2-bin libcmocka-dev perl openscad admesh imagemagick python3-ezdxf nodejs npm \
                  libocct-data-exchange-dev pkgconf
packages_pics  := $(packages_show) netpbm libjpeg-turbo-progs

cli_src := $(wildcard gen/cli/*.c)
lib_src := $(filter-out $(cli_src),$(wildcard gen/*/*.c gen/*/*/*.c formats/*.c formats/*/*.c))
shims   := $(wildcard gen/*/*_shim.cc gen/*/*/*_shim.cc formats/*/*_shim.cc)
# the shims hold CGAL, whose minutes under a sanitizer find nothing of ours: all configurations share them
lib_obj := $(lib_src:%.c=$(out)/obj/%.o) $(shims:%.cc=build/obj/%.o)
cli_obj := $(cli_src:%.c=$(out)/obj/%.o)
tests   := $(patsubst tests/%.c,$(out)/tests/%,$(wildcard tests/unit/*/test_*.c tests/api/test_*.c tests/torture/*.c))
# those with a word in their name, when make check is given one
chosen  := $(if $(only),$(foreach t,$(tests),$(if $(findstring $(only),$t),$t)),$(tests))
designs := $(patsubst templates/designs/%.yaml,%,$(wildcard templates/designs/*.yaml))
gallery := $(designs:%=renders/gallery/%.jpg)

# as many jobs as processors, unless make was told
jobs := $(if $(findstring -j,$(MAKEFLAGS)),,-j$(shell nproc))

.DELETE_ON_ERROR:
.SUFFIXES:
.SECONDARY:
.PHONY: all demo check models renders catalog bench accept layers format install help clean \
        setup-build setup-demo setup-check setup-pics

all: $(out)/lamella $(out)/liblamella.so

# ---- packages: installed where they are missing, otherwise nothing happens ----
define install_missing
@command -v dpkg-query >/dev/null || { echo "not Debian: install by hand: $(1)"; exit 0; }; \
missing=$$(for p in $(1); do dpkg-query -W -f='$${db:Status-Abbrev}' $$p 2>/dev/null | grep -q '^ii' || \
  { [ $$p = nodejs -o $$p = npm ] && command -v npm >/dev/null; } || echo $$p; done); \
[ -z "$$missing" ] && exit 0; \
echo "installing Debian packages:" $$missing; \
sudo=; [ "$$(id -u)" = 0 ] || sudo=sudo; \
$$sudo apt-get update -qq && DEBIAN_FRONTEND=noninteractive $$sudo apt-get install -qq -y --no-install-recommends $$missing >/dev/null
endef
setup-build: ; $(call install_missing,$(packages_build))
setup-demo:  ; $(call install_missing,$(packages_build) $(packages_show))
setup-check: ; $(call install_missing,$(packages_build) $(packages_check))
setup-pics:  ; $(call install_missing,$(packages_build) $(packages_pics))

# ---- program and library ----
$(out)/liblamella.a: $(lib_obj)
	@rm -f $@.part && ar rcsD $@.part $^ && mv $@.part $@
$(out)/liblamella.so: $(lib_obj) gen/lamella.map
	@echo "  link $@"
	@$(CXX) -shared $(opt) -Wl,-soname,liblamella.so.0 -Wl,--version-script=gen/lamella.map \
	  -o $@.part $(filter %.o,$^) $(libs) && mv $@.part $@
$(out)/lamella: $(cli_obj) $(out)/liblamella.a
	@echo "  link $@"
	@$(CXX) $(opt) -o $@.part $(cli_obj) $(out)/liblamella.a $(libs) && mv $@.part $@
# fronts are computed with the instructions that the processor turns out to have
ifneq ($(findstring x86_64,$(shell $(CC) -dumpmachine)),)
$(out)/obj/gen/solve/factor/front_avx512.o: CFLAGS_ += -mavx512f -mfma
$(out)/obj/gen/solve/factor/front_avx2.o: CFLAGS_ += -mavx -mfma
endif
ifeq ($(config),release)
$(out)/obj/gen/solve/factor/front_%.o: opt += -O3
endif
$(out)/obj/%.o: %.c
	@mkdir -p $(@D)
	@echo "  cc   $<"
	@$(CC) $(CFLAGS_) -c $< -o $@
build/obj/%.o: %.cc
	@mkdir -p $(@D)
	@echo "  c++  $<"
	@$(CXX) $(CXXFLAGS_) -c $< -o $@
# a second opinion on our factorization
$(out)/tests/unit/solve/test_factor $(out)/tests/bench/second_opinion: second := -lcholmod
$(out)/tests/%: tests/%.c $(out)/liblamella.a
	@mkdir -p $(@D)
	@echo "  test $<"
	@$(CC) $(CFLAGS_) -DLAM_FUZZ_DRIVER -Itests/unit -o $@ $< $(out)/liblamella.a -lcmocka $(second) $(libs)
-include $(lib_obj:.o=.d) $(cli_obj:.o=.d) $(tests:=.d)

# ---- models: one folder per design; a design's rule lists the templates and meshes it used ----
models: $(designs:%=build/models/%/report.json)
build/models/%/report.json: templates/designs/%.yaml build/lamella
	@echo "  make $*"
	@rm -rf $(@D) && mkdir -p $(@D)
	@build/lamella build $< -o $(@D) --deps build/models/$*.d --skip png >build/models/$*.txt || { cat build/models/$*.txt; exit 1; }
-include $(designs:%=build/models/%.d)

demo: setup-demo
	@$(MAKE) --no-print-directory $(jobs) build/demo/report.json
	@cat build/demo.txt
	@echo; echo "files in build/demo:"; cd build/demo && ls -p | grep -v / | sed 's|^|  |'; \
	 for d in parts sheets; do echo "  $$d/: $$(ls $$d | wc -l) files, $$(ls $$d | head -n 1) ..."; done
build/demo/report.json: templates/designs/asymptotic-pavilion.yaml build/lamella
	@rm -rf build/demo && mkdir -p build/demo
	build/lamella build $< -o build/demo --deps build/demo.d --picture middle >build/demo.txt || { cat build/demo.txt; exit 1; }
-include build/demo.d

# ---- pictures for the README: minutes each for the large ones, less than one for all others ----
large := asymptotic-pavilion constant-ratio-vault enneper-model hypar-roof
renders: setup-pics
	@$(MAKE) --no-print-directory $(jobs) $(gallery)
	@$(MAKE) --no-print-directory catalog
# the page of all pictures, from the titles and sources of the designs
catalog:
	@awk -F': *' 'BEGIN { print "# Shipped designs\n\n`lamella new NAME` copies one to start from.\n\n| | | |\n|---|---|---|" } \
	  FNR == 1 { if (n) cell(); name = FILENAME; sub(/.*\//, "", name); sub(/\.yaml$$/, "", name); title = source = ""; n++ } \
	  /^title:/ { title = substr($$0, 8) } /^source:/ { source = substr($$0, 9) } \
	  function cell() { printf "%s ![](%s.jpg) `%s`: %s%s%s", (n - 1) % 3 == 0 ? "|" : " |", name, name, title, source ? ". " : "", source; \
	    if ((n - 1) % 3 == 2) print " |" } \
	  END { cell(); if (n % 3) { while (++n % 3) printf " |"; print " |" } }' \
	  $(sort $(wildcard templates/designs/*.yaml)) >renders/gallery/README.md
renders/gallery/%.jpg: build/models/%/report.json
	@echo "  render $*"
	@mkdir -p $(@D)
	@build/lamella build templates/designs/$*.yaml -o build/models/$* --only pov,png --quiet \
	  $(if $(filter $*,$(large)),--picture final,--picture thumb --set 'render.size=[640,360]')
	@pngtopnm build/models/$*/$*.png | cjpeg -quality 88 -optimize >$@.part && mv $@.part $@

# ---- tests ----
check: setup-check
	@$(MAKE) --no-print-directory $(jobs) all $(chosen)
	@LAMELLA=$(abspath $(out)/lamella) LAM_TESTS=$(out)/tests tests/run $(only)
accept: all
	@LAMELLA=$(abspath $(out)/lamella) LAM_ACCEPT=1 tests/golden/golden.t
bench: setup-build
	@$(MAKE) --no-print-directory $(jobs) build/lamella
	@build/lamella bench tests/cases/nets
	@$(MAKE) --no-print-directory build/tests/bench/second_opinion && build/tests/bench/second_opinion
layers:
	@tests/layers
format:
	clang-format -i $$(git ls-files '*.c' '*.h' '*.cc')

install: all
	install -d $(DESTDIR)$(prefix)/bin $(DESTDIR)$(prefix)/lib/pkgconfig \
	  $(DESTDIR)$(prefix)/include/lamella $(DESTDIR)$(prefix)/share/man/man1 $(DESTDIR)$(prefix)/share/lamella
	install $(out)/lamella $(DESTDIR)$(prefix)/bin/lamella
	install -m 644 $(out)/liblamella.a $(DESTDIR)$(prefix)/lib/
	install $(out)/liblamella.so $(DESTDIR)$(prefix)/lib/liblamella.so.0
	ln -sf liblamella.so.0 $(DESTDIR)$(prefix)/lib/liblamella.so
	install -m 644 gen/include/lamella/*.h $(DESTDIR)$(prefix)/include/lamella/
	sed 's|@prefix@|$(prefix)|; s|@version@|$(VERSION)|; s|@libs@|$(libs)|' gen/lamella.pc.in \
	  >$(DESTDIR)$(prefix)/lib/pkgconfig/lamella.pc
	install -m 644 gen/cli/lamella.1 $(DESTDIR)$(prefix)/share/man/man1/
	cp -R templates $(DESTDIR)$(prefix)/share/lamella/
clean:
	rm -rf build
help:
	@echo "make            the program build/lamella and the library build/liblamella.a, .so"
	@echo "make demo       installs what is missing, builds, and makes the pavilion in build/demo"
	@echo "make check      installs what is missing, builds, and runs all tests (only=WORD: those with WORD in their name)"
	@echo "make models     every shipped design, in build/models"
	@echo "make renders    the gallery: renders/gallery (minutes per picture)"
	@echo "make bench      speed, as ratios measured in one run"
	@echo "make accept     records new golden files after a change that was meant"
	@echo "make layers     checks which folder includes which"
	@echo "make format     clang-format"
	@echo "make install    to prefix=$(prefix)"
	@echo "config=release|debug|sanitize|thread|clang builds into build, build/debug, build/sanitize, build/thread, build/clang"
