package robotran.workshop.learning

import robotran.brick.kind.BrickKind
import robotran.language.ProgramLanguage
import robotran.languagesupport.TextLines
import robotran.learning.WordHelp
import robotran.learning.helpOn
import robotran.learning.wordAt
import robotran.programs.Program
import robotran.programs.support
import robotran.workshop.examples.examplesFor
import robotran.workshop.service.CurrentProject
import robotran.workshop.service.Preferences
import robotran.workshop.state.HelpState

/** Finds help on words and opens their examples. */
internal class HelpFinder(
    private val preferences: Preferences,
    private val current: CurrentProject,
    private val newTabs: NewTabs,
) {
    /** The language of the current program. */
    val shownCode: ProgramLanguage get() = current.shownProgram.language

    /** The brick of the shown robot. */
    val shownBrick: BrickKind get() = current.shownRobot.description.brick

    /** The help on the word at [offset] of the program [text]. */
    fun at(text: String, offset: Int): HelpState {
        val code = ProgramLanguage.entries.find { it.support.code.isRecognised(text) }
            ?: shownCode.takeIf { current.shownProgram.isForLegoFirmware }
            ?: ProgramLanguage.default
        val brick = code.support.code.brickOf(TextLines(text)) ?: shownBrick
        val found = helpOn(preferences.language, code, text, offset, brick)
        return HelpState(code, wordAt(text, offset), found?.inWords(code.support, preferences.words), brick)
    }

    /** The help on [word]; the list of all words for null. */
    fun on(programLanguage: ProgramLanguage, word: String?, brick: BrickKind = shownBrick): HelpState = HelpState(
        programLanguage,
        word,
        word?.let {
            WordHelp.of(preferences.language, programLanguage, it, brick)
                ?.inWords(programLanguage.support, preferences.words)
        },
        brick,
    )

    /**
     * Adds the example of [help] as a tab without running it. Returns false if there is no example. If there is no
     * room, shows a message and returns false.
     */
    fun tryExample(help: HelpState): Boolean {
        val example = help.found?.example ?: return false
        val files = help.programLanguage.support.files
        val name = files.nameFor("try")
        return newTabs.add(
            Program(name, help.programLanguage, files.wrapped(example, name, help.brick)),
            replacing = true,
        )
    }

    /**
     * Adds the example [name] as a tab without running it; in Java it is one for [brick]. If there is no room, shows a
     * message and returns false.
     */
    fun addExample(language: ProgramLanguage, name: String, brick: BrickKind): Boolean {
        val itsBrick = if (language.support.hasBlocks) shownBrick else brick
        val example = language.examplesFor(itsBrick)[name] ?: return false
        val program = Program.of(name, example).inWords(preferences.words)
        // The unchanged example may already be open.
        return newTabs.choose { it == program } || newTabs.add(program)
    }
}
