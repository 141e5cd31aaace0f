package robotran.robolang.nqc

import robotran.robolang.robot.RobotTarget
import robotran.robolang.translate.JavaWriter

/** What a translation uses of its helpers. */
internal class UsedNqcHelpers(val robot: RobotTarget.Rcx) {
    private val used = HashSet<NqcHelper>()

    /** Marks [helper] and what it needs as used; returns its name. */
    fun use(helper: NqcHelper): String {
        if (used.add(helper)) helper.needs.forEach { use(it) }
        return helper.called
    }

    fun isUsed(helper: NqcHelper): Boolean = helper in used

    /** Writes those that are used: figures first, then functions. */
    fun write(writer: JavaWriter) {
        for (helper in NqcHelper.entries.filter { it in used }) {
            if (helper != NqcHelper.CENTIMETRES && helper != NqcHelper.DEGREES) writer.blank()
            writer.lines(helper.textFor(robot))
        }
    }
}
