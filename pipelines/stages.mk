# The stages of the pipeline as rules, for the makefiles beside this one.
#
# $(eval $(call model_rules,PREFIX,MESH,SKETCH)) makes PREFIX.segment, PREFIX.hull and PREFIX.hullmap (.ply, .json);
# $(eval $(call pair_rules,FOLDER,SOURCE_PREFIX,TARGET_PREFIX)) makes the documents of one pair in FOLDER.
# Options of a stage go into its variable:
#   CONVERT_MESH_FLAGS SEGMENT_FLAGS HULL_FLAGS MAP_TO_HULL_FLAGS HULL_TO_HULL_FLAGS RECONSTRUCT_FLAGS
#   CRITICAL_POINTS_FLAGS RELOCATE_FLAGS MEASURE_FLAGS
# PARTWISE_BIN is the folder of the executables; by default that of the build or installation this file belongs to.
.DELETE_ON_ERROR:
.SUFFIXES:
MAKEFLAGS += --no-builtin-rules

stages_folder := $(dir $(abspath $(lastword $(MAKEFILE_LIST))))
PARTWISE_BIN ?= $(firstword $(wildcard $(stages_folder)../build/release/bin $(stages_folder)../../../libexec/partwise))
ifeq ($(wildcard $(PARTWISE_BIN)/segment),)
  $(error no executables in "$(PARTWISE_BIN)"; run `make -f Makefile.data build`, or say where they are: PARTWISE_BIN=folder)
endif

# $(call check_path,VARIABLE): stops when make could not handle the path in VARIABLE.
check_path = $(if $(or $(word 2,$($(1))),$(findstring :,$($(1))),$(findstring %,$($(1))),$(findstring ',$($(1)))),$(error \
  $(1)="$($(1))": make cannot handle paths with spaces, quotes, ":" or "%"; rename it or use a link))
# $(call check_input,VARIABLE,WHAT): stops when VARIABLE does not name an existing file.
check_input = $(call check_path,$(1))$(if $(wildcard $($(1))),,$(error \
  $(1)="$($(1))": $(if $($(1)),there is no such file,not given); say $(1)=$(2)))

document = $(1).ply $(1).json
# $(call povray,FOLDER,NAME): commands that render FOLDER/NAME.pov, which the tool picture wrote, as FOLDER/NAME.png.
# POV-Ray may read and write in the folder where it runs, not everywhere.
define povray
@cd '$(1)' && povray $$(sed -n '1s,^// *,,p' $(2).pov) +I$(2).pov +O$(2).part.png +FN -D +A0.2 +R3 \
  >$(2).log 2>&1 || { cat $(2).log >&2; exit 1; }
@cd '$(1)' && rm -f $(2).log && mv $(2).part.png $(2).png
endef
# $(call settings,FILE,WORDS): names FILE and rewrites it when WORDS change, so that what depends on it is made anew.
settings = $(1)$(if $(subst |settings: $(strip $(2))|,,|$(file <$(1))|),$(shell mkdir -p '$(dir $(1))')$(file \
  >$(1),settings: $(strip $(2))))
# $(call stage,OUTPUT,INPUTS,TOOL,FLAGS,OTHER PREREQUISITES): one rule "documents in, one document out".
define stage
$(call document,$(1)) &: $(foreach input,$(2),$(call document,$(input))) $(5) $(call settings,$(dir $(1)).settings/$(notdir $(1)),$(4))
	'$$(PARTWISE_BIN)/$(3)' $(addsuffix .ply,$(2)) $(4) --force -o $(1).ply
endef

# A PLY goes in as it is, any other format by convert-mesh.
define model_rules
$(if $(filter %.ply,$(2)),,
$(call document,$(1).mesh) &: $(2) $(call settings,$(dir $(1)).settings/$(notdir $(1)).mesh,$(2) $(CONVERT_MESH_FLAGS))
	'$$(PARTWISE_BIN)/convert-mesh' $(2) $(CONVERT_MESH_FLAGS) --force -o $(1).mesh.ply
)
$(call segment_rule,$(1),$(if $(filter %.ply,$(2)),$(2),$(1).mesh.ply),$(3))
$(call stage,$(1).hull,$(1).segment,hull,$(HULL_FLAGS))
$(call stage,$(1).hullmap,$(1).hull,map-to-hull,$(MAP_TO_HULL_FLAGS))
endef
define segment_rule
$(call document,$(1).segment) &: $(2) $(if $(filter $(1).mesh.ply,$(2)),$(1).mesh.json,$(wildcard $(2:.ply=.json))) $(3) $(call \
  settings,$(dir $(1)).settings/$(notdir $(1)).segment,$(2) $(3) $(SEGMENT_FLAGS))
	'$$(PARTWISE_BIN)/segment' $(2) $(if $(3),--sketch $(3)) $(SEGMENT_FLAGS) --force -o $(1).segment.ply
endef

define pair_rules
$(call stage,$(1)/crossmap,$(2).hullmap $(3).hullmap,hull-to-hull,$(HULL_TO_HULL_FLAGS))
$(call stage,$(1)/reconstructed,$(1)/crossmap,reconstruct,$(RECONSTRUCT_FLAGS))
$(call stage,$(1)/critical,$(1)/reconstructed,critical-points,$(CRITICAL_POINTS_FLAGS))
$(call stage,$(1)/compatible,$(1)/critical,relocate,$(RELOCATE_FLAGS))
$(1)/measure.json: $(call document,$(1)/compatible) $(call settings,$(1)/.settings/measure,$(MEASURE_FLAGS))
	'$$(PARTWISE_BIN)/measure' $(1)/compatible.ply $(MEASURE_FLAGS) --force -o $(1)/measure.json
endef
