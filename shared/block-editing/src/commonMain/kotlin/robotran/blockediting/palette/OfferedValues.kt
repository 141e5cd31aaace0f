package robotran.blockediting.palette

import robotran.blockediting.BlockProgram
import robotran.blockediting.fits
import robotran.blockediting.namesFor
import robotran.brick.kind.BrickKind
import robotran.brick.sensors.SensorKind
import robotran.robolang.outline.DeclaredName
import robotran.robolang.outline.NameKind
import robotran.robolang.outline.PhrasePart
import robotran.robolang.words.ValueForm
import robotran.robolang.words.ValueKind
import robotran.robolang.words.ValueUse

/** The names of this program that may be put at [part], as they stand there: a function is called with examples. */
fun BlockProgram.offeredNames(part: PhrasePart.Value): List<String> = namesFor(part).map(::valueOf)

/**
 * The other values that may be put at [part], as they will stand there: comparisons of the robot's [sensors] first, then
 * what the palette has for a robot with [brick].
 */
fun BlockProgram.offeredValues(part: PhrasePart.Value, sensors: Set<SensorKind>, brick: BrickKind): List<String> {
    val fitting = VALUES.getValue(brick).filter { (_, kind) -> fits(kind, part.use) }.map { it.first }
    val (comparisons, others) = fitting.partition { it.valueForm == ValueForm.COMPARISON }
    val compared = if (comparisons.isEmpty()) emptyList() else comparisonsFor(sensors, brick)
    return (compared + others.flatMap { it.textsAt(part, this) }).distinct()
}

private fun valueOf(name: DeclaredName): String = if (name.kind == NameKind.FUNCTION) {
    name.parameters.joinToString(prefix = "${name.text}(", postfix = ")") { ValueUse.ANY.example }
} else {
    name.text
}

/** The values of the palette with their types. */
private val VALUES: Map<BrickKind, List<Pair<PaletteBlock, ValueKind>>> by lazy {
    BrickKind.entries.associateWith { brick ->
        Palette.blocksFor(brick).filter { it.isValue && it.valueForm !in WRITTEN }.map { it to it.valueKind }
    }
}

/** Whether pupils write this value, so that the palette does not offer it: plain numbers, and brackets. */
val PaletteBlock.isWritten: Boolean get() = isValue && valueForm in WRITTEN

private val WRITTEN = setOf(ValueForm.NUMBER, ValueForm.BRACKETS)
