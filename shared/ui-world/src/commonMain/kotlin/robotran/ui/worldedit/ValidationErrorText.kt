package robotran.ui.worldedit

import androidx.compose.runtime.Composable
import robotran.editing.WorldEditorTexts
import robotran.uikit.*
import robotran.world.World
import robotran.worldediting.ElementKind
import robotran.worldediting.ValidationError
import robotran.worldediting.WorldEditError
import robotran.worldediting.max

/** A validation error as a sentence. */
@Composable
internal fun validationErrorText(world: World, error: ValidationError): String = when (error) {
    is ValidationError.Obstructed -> WorldEditorTexts.troubleInTheWay(
        spoken,
        elementText(world, error.thing),
        elementText(world, error.other),
    )

    is ValidationError.OffPaper -> WorldEditorTexts.troubleOffPaper(spoken, elementText(world, error.thing))

    is ValidationError.SelfIntersecting -> WorldEditorTexts.troubleTangled(spoken, elementText(world, error.thing))

    is ValidationError.MissingActor -> WorldEditorTexts.troubleNobody(spoken, error.name)
    is ValidationError.MissingLine -> WorldEditorTexts.troubleNoLine(spoken, error.name)
    is ValidationError.MissingTemplate -> WorldEditorTexts.troubleNoTemplate(spoken)
    is ValidationError.Rejected -> error.message(LocalLanguage.current)
}

/** The reason of a rejected edit as a sentence. */
@Composable
internal fun editErrorText(error: WorldEditError): String = when (error) {
    is WorldEditError.TooMany -> WorldEditorTexts.refusalTooMany(spoken, kindsWord(error.kind)(spoken), max(error.kind))

    WorldEditError.TooManyPoints -> WorldEditorTexts.refusalPoints(spoken)
    WorldEditError.TooFar -> WorldEditorTexts.refusalFar(spoken)
    WorldEditError.InvalidSize -> WorldEditorTexts.refusalSize(spoken)
    WorldEditError.OutOfRange -> WorldEditorTexts.refusalRange(spoken)
    WorldEditError.TooFewCorners -> WorldEditorTexts.refusalCorners(spoken)
    WorldEditError.CoincidentPoints -> WorldEditorTexts.refusalSamePlace(spoken)
    is WorldEditError.NameTaken -> WorldEditorTexts.refusalName(spoken, error.name)
    WorldEditError.InvalidText -> WorldEditorTexts.refusalText(spoken)
    WorldEditError.LastRobot -> WorldEditorTexts.refusalLastRobot(spoken)
    WorldEditError.NeedsLine -> WorldEditorTexts.refusalNeedsLine(spoken)
    WorldEditError.NeedsTemplate -> WorldEditorTexts.refusalNeedsTemplate(spoken)
    WorldEditError.TooDeep -> WorldEditorTexts.refusalDeep(spoken)
}

/** The plural of an element kind. */
internal fun kindsWord(kind: ElementKind): Label = when (kind) {
    ElementKind.MARK -> WorldEditorTexts::kindMarks
    ElementKind.STROKE -> WorldEditorTexts::kindStrokes
    ElementKind.GOAL -> WorldEditorTexts::kindGoals
    ElementKind.WALL -> WorldEditorTexts::kindWalls
    ElementKind.BARRIER -> WorldEditorTexts::kindBarriers
    ElementKind.BLOCK -> WorldEditorTexts::kindBlocks
    ElementKind.ROBOT -> WorldEditorTexts::kindRobots
    ElementKind.LAMP -> WorldEditorTexts::kindLamps
}
