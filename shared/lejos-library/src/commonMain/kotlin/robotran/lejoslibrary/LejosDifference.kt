package robotran.lejoslibrary

import robotran.tinyvm.config.LejosVersion

/**
 * Something of the class library that leJOS lacks, or has only from some version on.
 *
 * @property owner the class through which a program names it, with slashes, such as `java/util/Stack`.
 * @property member a method or constructor as name and descriptor, such as `search(Ljava/lang/Object;)I`; a field as
 * name, colon and descriptor, such as `SENSOR_TYPE_RAW:I`; empty for the class itself.
 * @property since the first version of leJOS that has it as it is here, or null if no version has.
 * @property instead what a program for a brick without it can do.
 */
data class LejosDifference(val owner: String, val member: String, val since: LejosVersion?, val instead: LejosRemedy) {
    /** Whether leJOS [version] has it as it is here. */
    fun isIn(version: LejosVersion): Boolean = since != null && since <= version
}
