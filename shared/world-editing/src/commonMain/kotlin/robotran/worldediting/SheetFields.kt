package robotran.worldediting

import robotran.editing.Field
import robotran.editing.NumberSpec
import robotran.editing.TextKind
import robotran.editing.TextSpec
import robotran.editing.WorldEditorTexts
import robotran.world.WorldLimits

/** The fields of a world as a whole. */
fun fieldsOf(sheet: SheetProperties): List<Field<SheetProperties>> = with(sheet) {
    listOf(
        Field.Text("field-title", WorldEditorTexts::title, title, TITLE) { copy(title = it) },
        Field.Text("field-task", WorldEditorTexts::task, task, TASK, WorldEditorTexts::taskHint) { copy(task = it) },
        Field.Heading(WorldEditorTexts::paper),
        Field.Number("field-paper-width", WorldEditorTexts::width, width, SIDE) { copy(width = it) },
        Field.Number("field-paper-height", WorldEditorTexts::height, height, SIDE) { copy(height = it) },
        Field.Heading(WorldEditorTexts::room),
        Field.Number("field-light", WorldEditorTexts::light, ambientLight, LIGHT) { copy(ambientLight = it) },
        Field.Number("field-temperature", WorldEditorTexts::temperature, temperature, TEMPERATURE) {
            copy(temperature = it)
        },
        Field.Heading(WorldEditorTexts::run),
        Field.Number("field-time-limit", WorldEditorTexts::timeLimit, timeLimit.toDouble(), TIME) {
            copy(timeLimit = it.toInt())
        },
        Field.Number("field-realism", WorldEditorTexts::realism, realism, REALISM) { copy(realism = it) },
        Field.Help(WorldEditorTexts::realismHelp),
        Field.Number("field-seed", WorldEditorTexts::seed, seed.toDouble(), SEED) { copy(seed = it.toInt()) },
        Field.Help(WorldEditorTexts::seedHelp),
    )
}

private val TITLE = TextSpec(WorldLimits.MAXIMUM_TITLE_CHARACTERS)
private val TASK = TextSpec(WorldLimits.MAXIMUM_TASK_CHARACTERS, TextKind.PROSE, mayBeBlank = true)
private val SIDE =
    NumberSpec(WorldLimits.MINIMUM_PAPER_SIDE..WorldLimits.MAXIMUM_PAPER_SIDE, step = 10.0, unit = "cm")
private val LIGHT = NumberSpec(0.0..WorldLimits.MAXIMUM_BRIGHTNESS, step = 0.1, slider = 0.0..2.0)
private val TEMPERATURES = WorldLimits.MINIMUM_TEMPERATURE..WorldLimits.MAXIMUM_TEMPERATURE
private val TEMPERATURE = NumberSpec(TEMPERATURES, unit = "°C", slider = -20.0..50.0)
private val TIME = NumberSpec(1..WorldLimits.MAXIMUM_SECONDS, step = 10.0, unit = "s", slider = 10.0..300.0)
private val REALISM = NumberSpec(0.0..1.0, isPercent = true, step = 10.0, unit = "%", slider = 0.0..100.0)
private val SEED = NumberSpec(0..Int.MAX_VALUE)
