package robotran.ui.worldedit

import androidx.compose.runtime.Composable
import org.jetbrains.compose.resources.stringResource
import robotran.ui.resources.*
import robotran.world.WorldLimits
import robotran.worldediting.Edit
import robotran.worldediting.SheetProperties
import robotran.worldediting.figures

/** All properties of the world as a whole. */
@Composable
internal fun WorldPanel(making: EditorScope, newTitle: String) {
    val figures = making.world.figures
    val change = { changed: SheetProperties -> making.make(Edit.ChangeSheet(changed)) }
    TextRow(
        stringResource(Res.string.worldedit_title),
        figures.title,
        WorldLimits.MAXIMUM_TITLE_CHARACTERS,
        "field-title",
        { change(figures.copy(title = it)) },
        making::settle,
    )
    TextRow(
        stringResource(Res.string.worldedit_task),
        figures.task,
        WorldLimits.MAXIMUM_TASK_CHARACTERS,
        "field-task",
        { change(figures.copy(task = it)) },
        making::settle,
        mayBeBlank = true,
        isProse = true,
        hint = stringResource(Res.string.worldedit_task_hint),
    )
    val sides = WorldLimits.MINIMUM_PAPER_SIDE..WorldLimits.MAXIMUM_PAPER_SIDE
    RowHeading(stringResource(Res.string.worldedit_paper))
    NumberRow(
        stringResource(Res.string.worldedit_width),
        figures.width,
        sides,
        "field-paper-width",
        { change(figures.copy(width = it)) },
        making::settle,
        step = 10.0,
        unit = "cm",
    )
    NumberRow(
        stringResource(Res.string.worldedit_height),
        figures.height,
        sides,
        "field-paper-height",
        { change(figures.copy(height = it)) },
        making::settle,
        step = 10.0,
        unit = "cm",
    )
    RowHeading(stringResource(Res.string.worldedit_room))
    NumberRow(
        stringResource(Res.string.worldedit_light),
        figures.ambientLight,
        0.0..WorldLimits.MAXIMUM_BRIGHTNESS,
        "field-light",
        { change(figures.copy(ambientLight = it)) },
        making::settle,
        step = 0.1,
        slider = 0f..2f,
    )
    NumberRow(
        stringResource(Res.string.worldedit_temperature),
        figures.temperature,
        WorldLimits.MINIMUM_TEMPERATURE..WorldLimits.MAXIMUM_TEMPERATURE,
        "field-temperature",
        { change(figures.copy(temperature = it)) },
        making::settle,
        unit = "°C",
        slider = -20f..50f,
    )
    RowHeading(stringResource(Res.string.worldedit_run))
    NumberRow(
        stringResource(Res.string.worldedit_time_limit),
        figures.timeLimit.toDouble(),
        1.0..WorldLimits.MAXIMUM_SECONDS.toDouble(),
        "field-time-limit",
        {
            change(figures.copy(timeLimit = it.toInt()))
        },
        making::settle,
        step = 10.0,
        unit = "s",
        isWhole = true,
        slider = 10f..300f,
    )
    NumberRow(
        stringResource(Res.string.worldedit_realism),
        figures.realism * PERCENT,
        0.0..PERCENT,
        "field-realism",
        { change(figures.copy(realism = it / PERCENT)) },
        making::settle,
        step = 10.0,
        unit = "%",
        slider = 0f..100f,
    )
    Remark(stringResource(Res.string.worldedit_realism_help))
    NumberRow(
        stringResource(Res.string.worldedit_seed),
        figures.seed.toDouble(),
        0.0..Int.MAX_VALUE.toDouble(),
        "field-seed",
        { change(figures.copy(seed = it.toInt())) },
        making::settle,
        isWhole = true,
    )
    Remark(stringResource(Res.string.worldedit_seed_help))
    RowHeading(stringResource(Res.string.worldedit_start_over))
    WordButton(stringResource(Res.string.worldedit_new_world), "new-world", {
        making.makeAtOnce(Edit.NewWorld(newTitle))
    })
    Remark(stringResource(Res.string.worldedit_new_world_help))
}

private const val PERCENT = 100.0
