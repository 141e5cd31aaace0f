package robotran.ui.worldedit

import androidx.compose.runtime.Composable
import robotran.ui.texts.WorldEditorTexts
import robotran.uikit.*
import robotran.world.GoalCondition
import robotran.world.MarkFigure
import robotran.world.TouchKind
import robotran.worldediting.Element
import robotran.worldediting.ElementKind
import robotran.worldediting.ElementRef
import robotran.worldediting.GoalField
import robotran.worldediting.NumberSpec
import robotran.worldediting.WorldEdit

/** The input for a property of a goal. */
@Composable
internal fun GoalFieldRow(sender: GoalSender, field: GoalField) {
    val words = wordsFor(field.name)
    when (field) {
        is GoalField.Flag -> {
            SwitchRow(words.label(spoken), field.isOn, words.tag) { sender.once(field.with(it)) }
        }

        is GoalField.Text -> {
            TextRow(
                words.label(spoken),
                field.text,
                field.maximum,
                words.tag,
                {
                    sender.change(field.with(it))
                },
                sender::settle,
            )
        }

        is GoalField.Number -> SpecifiedNumberRow(sender, words, field.value, field.spec, field.with)

        is GoalField.OptionalNumber -> {
            SwitchRow(words.switchLabel(spoken), field.value != null, words.switchTag) { on ->
                sender.once(field.with(field.default.takeIf { on }))
            }
            field.value?.let { SpecifiedNumberRow(sender, words, it, field.spec, field.with) }
        }

        is GoalField.Line -> LineRow(sender, words, field)
        is GoalField.TouchKinds -> TouchRows(sender, words, field)
    }
}

@Composable
private fun SpecifiedNumberRow(
    sender: GoalSender,
    words: GoalFieldWords,
    value: Double,
    spec: NumberSpec,
    with: (Double) -> GoalCondition,
) {
    val factor = if (spec.isPercent) PERCENT else 1.0
    val slider = spec.slider?.let { it.start.toFloat()..it.endInclusive.toFloat() }
    NumberRow(
        words.label(spoken),
        value * factor,
        spec.range.start * factor..spec.range.endInclusive * factor,
        words.tag,
        { sender.change(with(it / factor)) },
        sender::settle,
        step = spec.step,
        unit = spec.unit,
        slider = slider,
        isWhole = spec.isWhole,
    )
}

@Composable
private fun LineRow(sender: GoalSender, words: GoalFieldWords, field: GoalField.Line) {
    val world = sender.making.world
    val lines = world.marks.indices.filter {
        world.marks[it].figure is MarkFigure.Line
    }.map { ElementRef(ElementKind.MARK, it) }
    val choices = lines.map { it to elementText(world, it) }
    MenuRow(words.label(spoken), choices, field.line, words.tag) { line ->
        sender.making.nameAnd(line, choices) { name -> WorldEdit.Change(sender.thing, sender.piece(field.with(name))) }
    }
}

@Composable
private fun TouchRows(sender: GoalSender, words: GoalFieldWords, field: GoalField.TouchKinds) {
    RowHeading(words.label(spoken))
    for (kind in TouchKind.entries) {
        SwitchRow(touchWord(kind)(spoken), kind in field.kinds, "touch-${kind.name.lowercase()}") { on ->
            sender.once(field.with(if (on) field.kinds + kind else field.kinds - kind))
        }
    }
}

private fun touchWord(kind: TouchKind): Label = when (kind) {
    TouchKind.WALLS -> WorldEditorTexts::kindWalls
    TouchKind.BARRIERS -> WorldEditorTexts::kindBarriers
    TouchKind.BLOCKS -> WorldEditorTexts::kindBlocks
    TouchKind.ROBOTS -> WorldEditorTexts::kindRobots
}

private const val PERCENT = 100.0
