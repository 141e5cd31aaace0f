package robotran.workshop.programs

import robotran.brick.kind.BrickKind
import robotran.language.Language
import robotran.programs.Program
import robotran.programs.ProgramCompiler
import robotran.programs.brickOf
import robotran.programs.support
import robotran.projects.penbotTarget

/** Finds out whether a program with mistakes is for another brick. It is asked often and remembers its last answer. */
internal class OtherBrickFinder {
    private var asked: Pair<Program, BrickKind>? = null
    private var answer: BrickKind? = null

    /**
     * The brick that [program] names or, with which it has no mistakes; null if that is the one of the
     * [robot] or nothing tells.
     */
    fun find(program: Program, robot: BrickKind): BrickKind? {
        val now = program to robot
        if (now != asked) {
            asked = now
            val named = brickOf(program)
            answer = if (named == null) brickByWords(program, robot) else named.takeUnless { isFor(program, it, robot) }
        }
        return answer
    }

    private fun isFor(program: Program, named: BrickKind, robot: BrickKind): Boolean =
        program.language.support.files.isFor(named, robot)

    /** The first other brick that all of a program is for. */
    private fun brickByWords(program: Program, robot: BrickKind): BrickKind? {
        if (program.language.support.hasSlowCompiler || program.characters > LONGEST) return null
        return BrickKind.entries.filter { it != robot }
            .firstOrNull { ProgramCompiler(it.penbotTarget, language = Language.ENGLISH).accepts(program) }
    }

    private companion object {
        /** In characters. Longer programs would be read too often while somebody types. */
        const val LONGEST = 20_000
    }
}
