package robotran.ui.worldedit

import androidx.compose.runtime.Composable
import robotran.ui.texts.WorldEditorTexts
import robotran.uikit.*
import robotran.world.HasActor
import robotran.world.WorldLimits
import robotran.worldediting.ElementKind
import robotran.worldediting.ElementRef
import robotran.worldediting.WorldEdit
import robotran.worldediting.name
import robotran.worldediting.named
import robotran.worldediting.piece
import robotran.worldediting.uniqueName

/** Selects robots and, for goals about a place, blocks. */
@Composable
internal fun WhoField(sender: GoalSender, condition: HasActor) {
    val world = sender.making.world
    val robots = world.robots.indices.drop(1).map { ElementRef(ElementKind.ROBOT, it) }
    val blocks = if (condition.mayBeBlock) {
        world.blocks.indices.map { ElementRef(ElementKind.BLOCK, it) }
    } else {
        emptyList()
    }
    val first = ElementRef(ElementKind.ROBOT, 0)
    val choices = (listOf(first) + robots + blocks).map { it to elementText(world, it) }
    val shown = condition.who ?: choices.first().second
    MenuRow(WorldEditorTexts.who(spoken), choices, shown, "field-who") { thing ->
        if (thing == first) {
            sender.once(condition.withWho(null))
        } else {
            sender.making.nameAnd(thing, choices) { name ->
                WorldEdit.Change(sender.thing, sender.piece(condition.withWho(name)))
            }
        }
    }
}

/**
 * Goals refer to elements by name. If [ref] has no name, names it by its word in [words], and applies [next] in the
 * same step.
 */
internal fun EditorScope.nameAnd(ref: ElementRef, words: List<Pair<ElementRef, String>>, next: (String) -> WorldEdit) {
    val piece = world.piece(ref) ?: return
    val known = piece.name
    if (known != null) return makeAtOnce(next(known))
    val name = world.uniqueName(words.first { it.first == ref }.second.take(WorldLimits.MAXIMUM_NAME_CHARACTERS))
    makeAtOnce(WorldEdit.Batch(listOf(WorldEdit.Change(ref, piece.named(name)), next(name))))
}
