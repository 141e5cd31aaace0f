package robotran.ui.worldedit

import androidx.compose.runtime.Composable
import org.jetbrains.compose.resources.StringResource
import org.jetbrains.compose.resources.stringResource
import robotran.ui.language.LocalLanguage
import robotran.ui.resources.*
import robotran.world.World
import robotran.worldediting.EditError
import robotran.worldediting.ElementKind
import robotran.worldediting.ValidationError
import robotran.worldediting.max

/** A validation error as a sentence. */
@Composable
internal fun validationErrorText(world: World, error: ValidationError): String = when (error) {
    is ValidationError.Obstructed -> stringResource(
        Res.string.worldedit_trouble_in_the_way,
        elementText(world, error.thing),
        elementText(world, error.other),
    )

    is ValidationError.OffPaper -> stringResource(
        Res.string.worldedit_trouble_off_paper,
        elementText(world, error.thing),
    )

    is ValidationError.SelfIntersecting -> stringResource(
        Res.string.worldedit_trouble_tangled,
        elementText(world, error.thing),
    )

    is ValidationError.MissingActor -> stringResource(Res.string.worldedit_trouble_nobody, error.name)
    is ValidationError.MissingLine -> stringResource(Res.string.worldedit_trouble_no_line, error.name)
    is ValidationError.MissingTemplate -> stringResource(Res.string.worldedit_trouble_no_template)
    is ValidationError.Rejected -> error.message(LocalLanguage.current)
}

/** The reason of a rejected edit as a sentence. */
@Composable
internal fun editErrorText(error: EditError): String = when (error) {
    is EditError.TooMany -> stringResource(
        Res.string.worldedit_refusal_too_many,
        stringResource(kindsWord(error.kind)),
        max(error.kind),
    )

    EditError.TooManyPoints -> stringResource(Res.string.worldedit_refusal_points)
    EditError.TooFar -> stringResource(Res.string.worldedit_refusal_far)
    EditError.InvalidSize -> stringResource(Res.string.worldedit_refusal_size)
    EditError.OutOfRange -> stringResource(Res.string.worldedit_refusal_range)
    EditError.TooFewCorners -> stringResource(Res.string.worldedit_refusal_corners)
    EditError.CoincidentPoints -> stringResource(Res.string.worldedit_refusal_same_place)
    is EditError.NameTaken -> stringResource(Res.string.worldedit_refusal_name, error.name)
    EditError.InvalidText -> stringResource(Res.string.worldedit_refusal_text)
    EditError.LastRobot -> stringResource(Res.string.worldedit_refusal_last_robot)
    EditError.NeedsLine -> stringResource(Res.string.worldedit_refusal_needs_line)
    EditError.NeedsTemplate -> stringResource(Res.string.worldedit_refusal_needs_template)
    EditError.TooDeep -> stringResource(Res.string.worldedit_refusal_deep)
}

/** The plural of an element kind. */
internal fun kindsWord(kind: ElementKind): StringResource = when (kind) {
    ElementKind.MARK -> Res.string.worldedit_kind_marks
    ElementKind.STROKE -> Res.string.worldedit_kind_strokes
    ElementKind.GOAL -> Res.string.worldedit_kind_goals
    ElementKind.WALL -> Res.string.worldedit_kind_walls
    ElementKind.BARRIER -> Res.string.worldedit_kind_barriers
    ElementKind.BLOCK -> Res.string.worldedit_kind_blocks
    ElementKind.ROBOT -> Res.string.worldedit_kind_robots
    ElementKind.LAMP -> Res.string.worldedit_kind_lamps
}
