package robotran.workshop.programs

import robotran.brick.kind.BrickKind
import robotran.language.ProgramLanguage
import robotran.programs.brickOf
import robotran.projects.penbotTarget
import robotran.robolang.RobolangResult
import robotran.robolang.compileRobolang
import robotran.workshop.state.PupilProgram

/** Finds out whether a program with mistakes is for the other brick. It is asked often and remembers its last answer. */
internal class OtherBrickFinder {
    private var asked: Pair<PupilProgram, BrickKind>? = null
    private var answer: BrickKind? = null

    /**
     * The brick that [program] names or, in Robolang, with which it has no mistakes; null if that is the one of the
     * [robot] or nothing tells.
     */
    fun find(program: PupilProgram, robot: BrickKind): BrickKind? {
        val now = program to robot
        if (now != asked) {
            asked = now
            answer = (brickOf(program.source()) ?: brickByWords(program, robot)).takeIf { it != robot }
        }
        return answer
    }

    /** The other brick if all of a Robolang program is for it. */
    private fun brickByWords(program: PupilProgram, robot: BrickKind): BrickKind? {
        val text = program.files.first().text
        if (program.language != ProgramLanguage.ROBOLANG || text.length > LONGEST) return null
        val other = BrickKind.entries.first { it != robot }
        return other.takeIf { compileRobolang(program.name, text, it.penbotTarget) is RobolangResult.Ready }
    }

    private companion object {
        /** In characters. Longer programs would be read too often while somebody types. */
        const val LONGEST = 20_000
    }
}
