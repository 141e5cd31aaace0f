package robotran.nqc

import robotran.legofirmware.image.FirmwareTarget

/** What the original compiler made of programs, see the README beside them. */
internal object Vectors {
    /** The sources by name without `.nqc`. */
    val programs: Map<String, String> = vectorFiles.filterKeys {
        it.endsWith(".nqc")
    }.mapKeys { it.key.removeSuffix(".nqc") }

    /** The image of a program as hexadecimal bytes, separated by blanks; null if it does not compile. */
    fun image(program: String, target: FirmwareTarget): String? {
        val suffix = if (target == FirmwareTarget.RCX) "rcx1" else "rcx2"
        return vectorFiles["$program.$suffix.hex"]?.split(Regex("\\s+"))?.filter { it.isNotEmpty() }?.joinToString(" ")
    }
}
