package robotran.ui.world

import androidx.compose.foundation.focusable
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.absoluteOffset
import androidx.compose.foundation.layout.size
import androidx.compose.runtime.Composable
import androidx.compose.runtime.key
import androidx.compose.ui.Modifier
import androidx.compose.ui.focus.onFocusChanged
import androidx.compose.ui.input.key.Key
import androidx.compose.ui.input.key.KeyEventType
import androidx.compose.ui.input.key.key
import androidx.compose.ui.input.key.onKeyEvent
import androidx.compose.ui.input.key.type
import androidx.compose.ui.platform.LocalDensity
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.CustomAccessibilityAction
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.customActions
import androidx.compose.ui.semantics.onClick
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.unit.IntOffset
import androidx.compose.ui.unit.max
import org.jetbrains.compose.resources.stringResource
import robotran.ui.resources.Res
import robotran.ui.resources.sheet_lamp_switch
import robotran.ui.resources.sheet_move_down
import robotran.ui.resources.sheet_move_left
import robotran.ui.resources.sheet_move_right
import robotran.ui.resources.sheet_move_up
import robotran.ui.resources.sheet_turn_left
import robotran.ui.resources.sheet_turn_right
import robotran.ui.sheet.SheetThing
import robotran.ui.sheet.SheetThingKind
import robotran.ui.sheet.SheetTransform
import robotran.ui.theme.Measures
import robotran.ui.theme.focusRing
import robotran.world.Pose
import robotran.world.SessionInput
import robotran.world.SessionState
import robotran.world.World

/** Places over the sheet where everything that can be moved has the keyboard's focus, and is told to who cannot see it. */
@Composable
internal fun ThingHandles(
    world: World,
    session: SessionState,
    view: SheetTransform,
    onInput: (SessionInput) -> Unit,
    onChosen: (SheetThing) -> Unit,
) {
    for (thing in movableThings(world)) {
        val pose = poseOf(thing, world, session) ?: continue
        key(thing) { ThingHandle(thing, pose, describeThing(thing, pose, world, session), world, session, view, onInput, onChosen) }
    }
}

@Composable
private fun ThingHandle(
    thing: SheetThing,
    pose: Pose,
    description: String,
    world: World,
    session: SessionState,
    view: SheetTransform,
    onInput: (SessionInput) -> Unit,
    onChosen: (SheetThing) -> Unit,
) {
    val place = view.toPixels(pose.x, pose.y)
    val size = with(LocalDensity.current) { max(Measures.TARGET, (view.toPixels(reachOf(thing, world)) * 2).toDp()) }
    val actions = actionsFor(thing, pose, onInput)
    val switch = SessionInput.SwitchLamp(thing.number, session.lamps.getOrNull(thing.number)?.on == false)
        .takeIf { thing.kind == SheetThingKind.LAMP }
    val switchWords = stringResource(Res.string.sheet_lamp_switch)
    Box(
        Modifier
            .absoluteOffset { IntOffset((place.x - size.toPx() / 2).toInt(), (place.y - size.toPx() / 2).toInt()) }
            .size(size)
            .testTag("thing-${thing.kind.name.lowercase()}-${thing.number}")
            .onFocusChanged { if (it.isFocused) onChosen(thing) }
            .focusRing(size / 2)
            .onKeyEvent { event ->
                val isPress = event.key == Key.Enter || event.key == Key.NumPadEnter || event.key == Key.Spacebar
                val input = if (isPress && event.type == KeyEventType.KeyDown) switch else inputOf(event, thing, pose)
                input?.let(onInput)
                input != null
            }
            .focusable()
            .semantics {
                contentDescription = description
                customActions = actions
                if (switch != null) {
                    onClick(switchWords) {
                        onInput(switch)
                        true
                    }
                }
            },
    )
}

@Composable
private fun actionsFor(thing: SheetThing, pose: Pose, onInput: (SessionInput) -> Unit): List<CustomAccessibilityAction> {
    fun action(words: String, input: SessionInput) = CustomAccessibilityAction(words) {
        onInput(input)
        true
    }
    return listOfNotNull(
        action(stringResource(Res.string.sheet_move_left), moved(thing, pose, -STEP, 0.0)),
        action(stringResource(Res.string.sheet_move_right), moved(thing, pose, STEP, 0.0)),
        action(stringResource(Res.string.sheet_move_up), moved(thing, pose, 0.0, STEP)),
        action(stringResource(Res.string.sheet_move_down), moved(thing, pose, 0.0, -STEP)),
        turned(thing, pose, TURN)?.let { action(stringResource(Res.string.sheet_turn_left), it) },
        turned(thing, pose, -TURN)?.let { action(stringResource(Res.string.sheet_turn_right), it) },
    )
}
