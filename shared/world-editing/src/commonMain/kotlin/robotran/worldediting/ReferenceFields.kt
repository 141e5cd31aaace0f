package robotran.worldediting

import robotran.editing.ChoiceLook
import robotran.editing.Field
import robotran.editing.Option
import robotran.editing.Words
import robotran.editing.WorldEditorTexts
import robotran.world.Goal
import robotran.world.GoalCondition
import robotran.world.HasActor
import robotran.world.HasLine
import robotran.world.MarkFigure
import robotran.world.World
import robotran.world.WorldLimits

// Goals refer to elements by name. Choosing an element without one gives it its name in the same step.

/** The line that a goal is about. */
internal fun WorldEditing.lineField(ref: ElementRef, goal: Goal, condition: HasLine): Field<WorldEdit> {
    val lines = world.marks.indices.filter { world.marks[it].figure is MarkFigure.Line }
        .map { ElementRef(ElementKind.MARK, it) }
    val shown: Words = { condition.line }
    return Field.Choice("field-line", WorldEditorTexts::line, options(lines), null, ChoiceLook.MENU, shown) {
        line,
        language,
        ->
        line?.let {
            world.referTo(it, elementWords(world, it)(language)) { name -> goal.with(ref, condition.withLine(name)) }
        }
    }
}

/** The robot that a goal is about or, for goals about a place, the block. */
internal fun WorldEditing.whoField(ref: ElementRef, goal: Goal, condition: HasActor): Field<WorldEdit> {
    val robots = world.robots.indices.map { ElementRef(ElementKind.ROBOT, it) }
    val blocks = world.blocks.indices.map { ElementRef(ElementKind.BLOCK, it) }
    val options = options(if (condition.mayBeBlock) robots + blocks else robots)
    val shown: Words = { condition.who ?: options.first().label(it) }
    return Field.Choice("field-who", WorldEditorTexts::who, options, null, ChoiceLook.MENU, shown) { who, language ->
        when (who) {
            null -> null
            robots.first() -> goal.with(ref, condition.withWho(null))

            else -> world.referTo(who, elementWords(world, who)(language)) { name ->
                goal.with(ref, condition.withWho(name))
            }
        }
    }
}

private fun WorldEditing.options(elements: List<ElementRef>): List<Option<ElementRef?>> =
    elements.map { Option(it, elementWords(world, it)) }

private fun Goal.with(ref: ElementRef, condition: GoalCondition): WorldEdit =
    WorldEdit.Change(ref, Element.OfGoal(copy(condition = condition)))

/** [next] with the name of [ref]; where it has none, it is named [word] first. */
private fun World.referTo(ref: ElementRef, word: String, next: (String) -> WorldEdit): WorldEdit? {
    val piece = piece(ref) ?: return null
    piece.name?.let { return next(it) }
    val name = uniqueName(word.take(WorldLimits.MAXIMUM_NAME_CHARACTERS))
    return WorldEdit.Batch(listOf(WorldEdit.Change(ref, piece.named(name)), next(name)))
}
