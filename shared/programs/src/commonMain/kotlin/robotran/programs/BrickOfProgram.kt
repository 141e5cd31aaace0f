package robotran.programs

import robotran.brick.kind.BrickKind

/** The kind of brick that this program is for; null if it does not tell, or names several. */
fun brickOf(program: ProgramSource): BrickKind? = when (program) {
    is ProgramSource.CompiledClasses -> brickOfClasses(program.classFiles.values)
    is ProgramSource.FirmwareImage -> BrickKind.ofLegoFirmware
    else -> program.language?.support?.files?.brickOf(program.files)
}

/** The kind of brick that this program is for, or that it most likely is for if it names none; null if nothing tells. */
fun likelyBrickOf(program: ProgramSource): BrickKind? =
    brickOf(program) ?: program.language?.support?.files?.likelyBrickOf(program.files)

/** Looks for names of packages among the constants of the [classFiles]. */
private fun brickOfClasses(classFiles: Collection<ByteArray>): BrickKind? = PACKAGES.filter { (start, _) ->
    classFiles.any { it.contains("$start/".encodeToByteArray()) }
}.values.singleOrNull()

private fun ByteArray.contains(part: ByteArray): Boolean =
    (0..size - part.size).any { place -> part.indices.all { this[place + it] == part[it] } }

/** The bricks by the root of their packages. */
private val PACKAGES = BrickKind.entries.mapNotNull { kind -> kind.java?.let { it.root to kind } }.toMap()
