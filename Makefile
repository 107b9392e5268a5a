# Everything is made here. `make help` lists the targets.
config ?= release
prefix ?= /usr/local

VERSION := 0.1.0
ifeq ($(config),release)
  out := build
  opt := -O2 -g -fno-omit-frame-pointer
else ifeq ($(config),debug)
  out := build/debug
  opt := -O0 -g3
else ifeq ($(config),sanitize)
  out := build/sanitize
  opt := -O1 -g -Wno-format-truncation -fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer
else
  $(error config is release, debug or sanitize, not "$(config)")
endif

CC ?= cc
CXX ?= c++
warn     := -Wall -Wextra -Werror -Wshadow
includes := -Igen -I. -isystem /usr/include/suitesparse
CFLAGS_   = -std=c11 -D_GNU_SOURCE -fPIC -ffp-contract=off $(opt) $(warn) $(includes) -DLAM_VERSION='"$(VERSION)"' -MMD -MP $(CFLAGS)
CXXFLAGS_ = -std=c++17 -fPIC $(opt) $(warn) $(includes) -MMD -MP $(CXXFLAGS)
libs     := -lcholmod -lamd -lopenblas -ltinygltf -lpolyclipping -lgmp -lmpfr -lyaml -ljansson -lpng -lstdc++ -lm

cli_src := $(wildcard gen/cli/*.c)
lib_src := $(filter-out $(cli_src),$(wildcard gen/*/*.c) $(wildcard formats/*.c))
shims   := $(wildcard gen/*/*_shim.cc) $(wildcard formats/*_shim.cc)
lib_obj := $(lib_src:%.c=$(out)/obj/%.o) $(shims:%.cc=$(out)/obj/%.o)
cli_obj := $(cli_src:%.c=$(out)/obj/%.o)

.DELETE_ON_ERROR:
.SUFFIXES:
.PHONY: all demo check models renders bench accept layers format install help clean setup

all: $(out)/lamella $(out)/liblamella.so

$(out)/liblamella.a: $(lib_obj)
	@rm -f $@.part && ar rcsD $@.part $^ && mv $@.part $@
$(out)/liblamella.so: $(lib_obj)
	@echo "  link $@"
	@$(CC) -shared $(opt) -Wl,-soname,liblamella.so.0 -o $@.part $^ $(libs) && mv $@.part $@
$(out)/lamella: $(cli_obj) $(out)/liblamella.a
	@echo "  link $@"
	@$(CC) $(opt) -o $@.part $(cli_obj) $(out)/liblamella.a $(libs) && mv $@.part $@

$(out)/obj/%.o: %.c
	@mkdir -p $(@D)
	@echo "  cc   $<"
	@$(CC) $(CFLAGS_) -c $< -o $@
$(out)/obj/%.o: %.cc
	@mkdir -p $(@D)
	@echo "  c++  $<"
	@$(CXX) $(CXXFLAGS_) -c $< -o $@
-include $(lib_obj:.o=.d) $(cli_obj:.o=.d)
