@file:OptIn(ExperimentalWasmJsInterop::class)

package robotran.web.window

import androidx.compose.ui.ExperimentalComposeUiApi
import androidx.compose.ui.InternalComposeUiApi
import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.input.pointer.PointerButton
import androidx.compose.ui.input.pointer.PointerButtons
import androidx.compose.ui.input.pointer.PointerEventType
import androidx.compose.ui.input.pointer.PointerId
import androidx.compose.ui.input.pointer.PointerKeyboardModifiers
import androidx.compose.ui.input.pointer.PointerType
import androidx.compose.ui.scene.ComposeScene
import androidx.compose.ui.scene.ComposeScenePointer
import org.w3c.dom.HTMLCanvasElement
import org.w3c.dom.events.Event
import org.w3c.dom.events.MouseEvent
import org.w3c.dom.events.WheelEvent
import org.w3c.dom.pointerevents.PointerEvent

/**
 * Passes touch, pen, mouse and wheel events on [canvas] to [scene]. Each touch event contains all fingers that are
 * down, as Compose expects.
 *
 * @param density device pixels per CSS pixel.
 * @param onDown called when a pointer goes down on the canvas.
 */
@OptIn(InternalComposeUiApi::class, ExperimentalComposeUiApi::class)
internal class PagePointers(
    private val canvas: HTMLCanvasElement,
    private val scene: ComposeScene,
    private val frames: SceneFrames,
    private val density: () -> Float,
    private val onDown: () -> Unit,
) {
    private val fingers = LinkedHashMap<Int, Offset>()

    /** The position of the mouse if it is over the canvas. */
    private var mouse: Offset? = null

    fun listen() {
        // Disables the browser's scrolling, zooming and back gestures here.
        canvas.style.setProperty("touch-action", "none")
        for (type in TYPES.keys) {
            canvas.addEventListener(type) { event ->
                take(event as PointerEvent, TYPES.getValue(type))
            }
        }
        canvas.addEventListener("wheel") { turn(it as WheelEvent) }
        // Keeps the focus on the current element: the text field or the canvas.
        canvas.addEventListener("mousedown", Event::preventDefault)
        canvas.addEventListener("contextmenu", Event::preventDefault)
    }

    private fun take(event: PointerEvent, type: PointerEventType) {
        if (type == PointerEventType.Press) {
            capture(canvas, event.pointerId)
            onDown()
        }
        if (event.pointerType == "mouse") mouse(event, type) else finger(event, type)
        if (type in CHANGING) frames.markPending()
    }

    private fun finger(event: PointerEvent, type: PointerEventType) {
        val id = event.pointerId
        when (type) {
            PointerEventType.Press -> {
                forgetMouse()
                fingers[id] = placeOf(event)
            }

            PointerEventType.Move, PointerEventType.Release -> {
                if (id in fingers) fingers[id] = placeOf(event) else return
            }

            else -> return
        }
        val isUp = type == PointerEventType.Release
        val pointers = fingers.map { (finger, position) ->
            ComposeScenePointer(
                PointerId(finger.toLong()),
                position,
                pressed = !(isUp && finger == id),
                type = PointerType.Touch,
            )
        }
        scene.sendPointerEvent(type, pointers, keyboardModifiers = modifiersOf(event), nativeEvent = event)
        if (isUp) fingers -= id
    }

    /**
     * After something closes under a resting mouse, Compose would treat the first touch as the mouse's, and nothing
     * would be pressed.
     */
    private fun forgetMouse() {
        mouse?.let { scene.sendPointerEvent(PointerEventType.Exit, it) }
        mouse = null
    }

    private fun mouse(event: PointerEvent, type: PointerEventType) {
        mouse = placeOf(event).takeIf { type != PointerEventType.Exit }
        scene.sendPointerEvent(
            type,
            placeOf(event),
            buttons = PointerButtons(event.buttons.toInt()),
            keyboardModifiers = modifiersOf(event),
            nativeEvent = event,
            button = if (type in CHANGING) BUTTONS.getOrNull(event.button.toInt()) else null,
        )
    }

    private fun turn(event: WheelEvent) {
        event.preventDefault()
        val pixels = UNITS.getOrElse(event.deltaMode) { 1f } * density()
        scene.sendPointerEvent(
            PointerEventType.Scroll,
            placeOf(event),
            scrollDelta = Offset(event.deltaX.toFloat(), event.deltaY.toFloat()) * pixels,
            buttons = PointerButtons(event.buttons.toInt()),
            keyboardModifiers = modifiersOf(event),
            nativeEvent = event,
        )
    }

    private fun placeOf(event: MouseEvent) = Offset(event.offsetX.toFloat(), event.offsetY.toFloat()) * density()

    private fun modifiersOf(event: MouseEvent) = PointerKeyboardModifiers(
        isCtrlPressed = event.ctrlKey,
        isMetaPressed = event.metaKey,
        isAltPressed = event.altKey,
        isShiftPressed = event.shiftKey,
    )

    private companion object {
        val TYPES = mapOf(
            "pointerdown" to PointerEventType.Press,
            "pointermove" to PointerEventType.Move,
            "pointerup" to PointerEventType.Release,
            "pointercancel" to PointerEventType.Release,
            "pointerenter" to PointerEventType.Enter,
            "pointerleave" to PointerEventType.Exit,
        )

        val CHANGING = setOf(PointerEventType.Press, PointerEventType.Release)

        /** Indexed by the button number of an event. */
        val BUTTONS =
            listOf(
                PointerButton.Primary,
                PointerButton.Tertiary,
                PointerButton.Secondary,
                PointerButton.Back,
                PointerButton.Forward,
            )

        /** CSS pixels per wheel unit: pixels, lines, pages. */
        val UNITS = listOf(1f, 16f, 400f)
    }
}

/** Sends all events of [pointer] to [canvas] until it is released, even outside of the canvas. */
private fun capture(canvas: HTMLCanvasElement, pointer: Int): Unit =
    js("{ try { canvas.setPointerCapture(pointer); } catch (gone) { /* It has come up already. */ } }")
