package robotran.projects

import robotran.brick.controls.BrickButton
import robotran.brick.kind.BrickKind
import robotran.language.ProgramLanguage
import robotran.tinyvm.config.TinyVmMode
import robotran.tinyvm.config.TinyVmSpeed
import robotran.world.file.wordFor

/** The keywords in a file for enum constants. */
internal val LANGUAGES: Map<String, ProgramLanguage> = ProgramLanguage.entries.associateBy { wordFor(it) }
internal val VIEWS: Map<String, ProgramView> = ProgramView.entries.associateBy { wordFor(it) }
internal val MODES: Map<String, TinyVmMode> = TinyVmMode.entries.associateBy { wordFor(it) }
internal val SPEEDS: Map<String, TinyVmSpeed> = TinyVmSpeed.entries.associateBy { wordFor(it) }

/** As on the brick and on the command line. */
internal val BUTTONS: Map<String, BrickButton> = BrickKind.allButtons.associateBy { wordFor(it).replace(' ', '-') }
