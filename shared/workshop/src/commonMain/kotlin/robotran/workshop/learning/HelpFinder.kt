package robotran.workshop.learning

import robotran.language.ProgramLanguage
import robotran.learning.WordHelp
import robotran.learning.helpOn
import robotran.learning.wordAt
import robotran.learning.wrapJavaExample
import robotran.rcxrom.Brick
import robotran.workshop.examples.examples
import robotran.workshop.programs.pupilPrograms
import robotran.workshop.service.CurrentProject
import robotran.workshop.service.Notices
import robotran.workshop.service.Preferences
import robotran.workshop.service.ProgramTabs
import robotran.workshop.service.ScreenNavigator
import robotran.workshop.state.HelpState
import robotran.workshop.state.Notice
import robotran.workshop.state.Pane
import robotran.workshop.state.PupilProgram

/** Finds help on words and opens their examples. */
internal class HelpFinder(
    private val preferences: Preferences,
    private val current: CurrentProject,
    private val tabs: ProgramTabs,
    private val navigator: ScreenNavigator,
    private val notices: Notices,
) {
    /** The language of the current program. */
    val shownCode: ProgramLanguage get() = current.shownProgram.language

    /** The help on the word at [offset] of the program [text]. */
    fun at(text: String, offset: Int): HelpState {
        val code = if (JAVA_CLASS.containsMatchIn(text)) ProgramLanguage.JAVA else ProgramLanguage.ROBOLANG
        return HelpState(code, wordAt(text, offset), helpOn(preferences.language, code, text, offset))
    }

    /** The help on [word]; the list of all words for null. */
    fun on(code: ProgramLanguage, word: String?): HelpState =
        HelpState(code, word, word?.let { WordHelp.of(preferences.language, code, it) })

    /**
     * Adds the example of [help] as a tab without running it. Returns false if there is no example. If there is no
     * room, shows a message and returns false.
     */
    fun tryExample(help: HelpState): Boolean {
        val example = help.found?.example ?: return false
        val program = when (help.code) {
            ProgramLanguage.ROBOLANG -> PupilProgram("try.robo", example)
            ProgramLanguage.JAVA -> PupilProgram("Try.java", wrapJavaExample(example))
        }
        return put(program)
    }

    /** Adds the example [name] as a tab without running it. If there is no room, shows a message and returns false. */
    fun addExample(language: ProgramLanguage, name: String): Boolean {
        val program = PupilProgram(name, language.examples[name] ?: return false)
        val index = current.project.pupilPrograms.indexOf(program)
        if (index < 0) return put(program, replacing = false)
        // The unchanged example is already open.
        tabs.chooseProgram(index)
        navigator.show(Pane.PROGRAM)
        return true
    }

    private fun put(program: PupilProgram, replacing: Boolean = true): Boolean {
        val programs = current.project.pupilPrograms
        if (programs.size >= Brick.MAX_PROGRAMS && !(replacing && programs.any { it.name == program.name })) {
            notices.show(Notice.NoSlotForExample)
            return false
        }
        tabs.addProgram(program, replacing)
        navigator.show(Pane.PROGRAM)
        return true
    }

    private companion object {
        /** Matches Java only; Robolang has no braces. */
        val JAVA_CLASS = Regex("\\b(class|interface)\\s+\\w+[^\\n]*\\{")
    }
}
