package robotran.ui.assignment.making

import androidx.compose.foundation.border
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.runtime.LaunchedEffect
import androidx.compose.runtime.getValue
import androidx.compose.runtime.key
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.remember
import androidx.compose.runtime.setValue
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.unit.dp
import org.jetbrains.compose.resources.stringResource
import robotran.projects.Assignment
import robotran.projects.AssignmentChecks
import robotran.projects.AssignmentLimits
import robotran.projects.WorldVariation
import robotran.ui.assignment.Quiet
import robotran.ui.learning.QuietButton
import robotran.ui.learning.SecondButton
import robotran.ui.parts.IconTouch
import robotran.ui.resources.Res
import robotran.ui.resources.make_fewer
import robotran.ui.resources.make_grading
import robotran.ui.resources.make_grading_help
import robotran.ui.resources.make_more
import robotran.ui.resources.make_seeds
import robotran.ui.resources.make_variation_add
import robotran.ui.resources.make_variation_name
import robotran.ui.resources.make_variation_new
import robotran.ui.resources.make_variation_open
import robotran.ui.resources.make_variation_remove
import robotran.ui.resources.make_variations
import robotran.ui.theme.LocalRobotranColours
import robotran.ui.theme.Shapes
import robotran.ui.theme.TextSizes
import robotran.workshop.event.AssignmentEvent
import robotran.workshop.event.WorkshopEvent
import robotran.world.WorldLimits

/** With which seeds and in which variations of the world hand-ins are graded. */
@Composable
internal fun GradingSection(assignment: Assignment, change: (Assignment) -> Unit, onEvent: (WorkshopEvent) -> Unit) {
    val checks = assignment.checks ?: return
    val keep = { changed: AssignmentChecks -> change(assignment.copy(checks = changed)) }
    Section(stringResource(Res.string.make_grading), "make-grading-section") {
        Quiet(stringResource(Res.string.make_grading_help), "make-grading-help")
        Seeds(checks, keep)
        Subtitle(stringResource(Res.string.make_variations))
        checks.variations.forEachIndexed { index, variation ->
            key(index) {
                VariationRow(
                    variation,
                    index,
                    { name ->
                        val named = variation.copy(name = name)
                        keep(checks.copy(variations = checks.variations.map { if (it === variation) named else it }))
                    },
                    { keep(checks.copy(variations = checks.variations.filterIndexed { at, _ -> at != index })) },
                    onEvent,
                )
            }
        }
        if (checks.variations.size < AssignmentLimits.MAXIMUM_VARIATIONS) {
            val name = stringResource(Res.string.make_variation_new, checks.variations.size + 1)
            SecondButton(stringResource(Res.string.make_variation_add), "make-variation-add", {
                onEvent(AssignmentEvent.VariationAdded(name))
            })
        }
    }
}

@Composable
private fun Seeds(checks: AssignmentChecks, keep: (AssignmentChecks) -> Unit) {
    val count = checks.seeds.count()
    val first = checks.seeds.first
    val take = { wanted: Int ->
        val seeds = wanted.coerceIn(1, AssignmentLimits.MAXIMUM_SEEDS)
        keep(checks.copy(seeds = first..<first + seeds))
    }
    Row(verticalAlignment = Alignment.CenterVertically) {
        IconTouch(MakeIcons.LESS, stringResource(Res.string.make_fewer), "make-seeds-less", { take(count - 1) })
        Text(
            stringResource(Res.string.make_seeds, count),
            Modifier.testTag("make-seeds"),
            color = LocalRobotranColours.current.onPane,
            fontSize = TextSizes.BODY,
        )
        IconTouch(MakeIcons.MORE, stringResource(Res.string.make_more), "make-seeds-more", { take(count + 1) })
    }
}

@Composable
private fun VariationRow(
    variation: WorldVariation,
    index: Int,
    onRename: (String) -> Unit,
    onRemove: () -> Unit,
    onEvent: (WorkshopEvent) -> Unit,
) {
    var name by remember { mutableStateOf(variation.name) }
    LaunchedEffect(variation.name) { name = variation.name }
    Column(
        Modifier
            .fillMaxWidth()
            .testTag("make-variation-$index")
            .border(1.dp, LocalRobotranColours.current.line, Shapes.MEDIUM)
            .padding(12.dp),
        Arrangement.spacedBy(4.dp),
    ) {
        Field(
            name,
            stringResource(Res.string.make_variation_name),
            "make-variation-name-$index",
            WorldLimits.MAXIMUM_TITLE_CHARACTERS,
        ) {
            name = it
            if (it.isNotBlank()) onRename(it)
        }
        Chips {
            SecondButton(stringResource(Res.string.make_variation_open), "make-variation-open-$index", {
                onEvent(AssignmentEvent.VariationOpened(index))
            })
            QuietButton(stringResource(Res.string.make_variation_remove), "make-variation-remove-$index", onRemove)
        }
    }
}
