package robotran.ui.assignment.making

import androidx.compose.foundation.border
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.widthIn
import androidx.compose.runtime.Composable
import androidx.compose.runtime.LaunchedEffect
import androidx.compose.runtime.getValue
import androidx.compose.runtime.key
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.remember
import androidx.compose.runtime.setValue
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.text.input.KeyboardType
import androidx.compose.ui.unit.dp
import robotran.projects.Assignment
import robotran.projects.AssignmentChecks
import robotran.projects.AssignmentLimits
import robotran.projects.WorldVariation
import robotran.ui.assignment.Quiet
import robotran.ui.school.tags.AssignmentTags
import robotran.ui.school.texts.SchoolTexts
import robotran.uikit.*
import robotran.workshop.event.AssignmentEvent
import robotran.workshop.event.WorkshopEvent
import robotran.world.WorldLimits

/** With which seeds and in which variations of the world hand-ins are graded. */
@Composable
internal fun GradingSection(assignment: Assignment, change: (Assignment) -> Unit, onEvent: (WorkshopEvent) -> Unit) {
    val checks = assignment.checks ?: return
    val keep = { changed: AssignmentChecks -> change(assignment.copy(checks = changed)) }
    Section(SchoolTexts.makeGrading(spoken), AssignmentTags.MAKE_GRADING_SECTION) {
        Quiet(SchoolTexts.makeGradingHelp(spoken), AssignmentTags.MAKE_GRADING_HELP)
        Seeds(checks, keep)
        Subtitle(SchoolTexts.makeVariations(spoken))
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
            val name = SchoolTexts.makeVariationNew(spoken, checks.variations.size + 1)
            Button(SchoolTexts.makeVariationAdd(spoken), AssignmentTags.MAKE_VARIATION_ADD, ButtonKind.SECOND) {
                onEvent(AssignmentEvent.VariationAdded(name))
            }
        }
    }
}

/** How many seeds there are: typed, or chosen. */
@Composable
private fun Seeds(checks: AssignmentChecks, keep: (AssignmentChecks) -> Unit) {
    val count = checks.seeds.count()
    val first = checks.seeds.first
    var typed by remember { mutableStateOf("$count") }
    // Undo and the choices bring another number here.
    LaunchedEffect(count) { if (typed.toIntOrNull() != count) typed = "$count" }
    val take = { wanted: Int -> keep(checks.copy(seeds = first..<first + wanted)) }
    Field(
        typed,
        SchoolTexts.makeSeeds(spoken),
        AssignmentTags.MAKE_SEEDS,
        SEED_DIGITS,
        modifier = Modifier.widthIn(max = SEEDS_WIDTH),
        keyboard = KeyboardType.Number,
    ) { text ->
        typed = text.filter { it in '0'..'9' }
        typed.toIntOrNull()?.takeIf { it in SEEDS }?.let(take)
    }
    if (typed.toIntOrNull()?.takeIf { it in SEEDS } == null) {
        Explanation(
            SchoolTexts.makeSeedsLimits(spoken, SEEDS.first, SEEDS.last),
            Modifier.testTag(AssignmentTags.MAKE_SEEDS_WRONG).announced(),
            bad = true,
        )
    }
    Chips {
        for (choice in SEED_CHOICES) {
            Chip("$choice", choice == count, AssignmentTags.makeSeeds(choice)) {
                typed = "$choice"
                take(choice)
            }
        }
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
            .testTag(AssignmentTags.makeVariation(index))
            .border(1.dp, LocalRobotranColours.current.line, Shapes.MEDIUM)
            .padding(12.dp),
        Arrangement.spacedBy(4.dp),
    ) {
        Field(
            name,
            SchoolTexts.makeVariationName(spoken),
            AssignmentTags.makeVariationName(index),
            WorldLimits.MAXIMUM_TITLE_CHARACTERS,
        ) {
            name = it
            if (it.isNotBlank()) onRename(it)
        }
        Chips {
            Button(SchoolTexts.makeVariationOpen(spoken), AssignmentTags.makeVariationOpen(index), ButtonKind.SECOND) {
                onEvent(AssignmentEvent.VariationOpened(index))
            }
            Button(
                SchoolTexts.makeVariationRemove(spoken),
                AssignmentTags.makeVariationRemove(index),
                ButtonKind.QUIET,
                onClick = onRemove,
            )
        }
    }
}

private val SEEDS = 1..AssignmentLimits.MAXIMUM_SEEDS
private val SEED_CHOICES = listOf(1, 5, 10, 20, 50).filter { it in SEEDS }
private const val SEED_DIGITS = 3
private val SEEDS_WIDTH = 240.dp
