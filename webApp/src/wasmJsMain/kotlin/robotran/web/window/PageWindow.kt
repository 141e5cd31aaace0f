@file:OptIn(ExperimentalWasmJsInterop::class)

package robotran.web.window

import androidx.compose.runtime.Composable
import androidx.compose.runtime.CompositionLocalProvider
import androidx.compose.runtime.LaunchedEffect
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableIntStateOf
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.setValue
import androidx.compose.runtime.snapshotFlow
import androidx.compose.ui.ExperimentalComposeUiApi
import androidx.compose.ui.InternalComposeUiApi
import androidx.compose.ui.LocalSystemTheme
import androidx.compose.ui.SystemTheme
import androidx.compose.ui.input.InputMode
import androidx.compose.ui.input.InputModeManager
import androidx.compose.ui.input.key.Key
import androidx.compose.ui.input.key.KeyEvent
import androidx.compose.ui.input.key.KeyEventType
import androidx.compose.ui.input.pointer.PointerIcon
import androidx.compose.ui.platform.LocalClipboardManager
import androidx.compose.ui.platform.PlatformContext
import androidx.compose.ui.platform.ViewConfiguration
import androidx.compose.ui.platform.WindowInfo
import androidx.compose.ui.scene.CanvasLayersComposeScene
import androidx.compose.ui.scene.ComposeScene
import androidx.compose.ui.scene.ComposeSceneContext
import androidx.compose.ui.text.input.PlatformTextInputService
import androidx.compose.ui.unit.Density
import androidx.compose.ui.unit.Dp
import androidx.compose.ui.unit.IntSize
import androidx.compose.ui.unit.dp
import kotlinx.browser.document
import kotlinx.browser.window
import kotlinx.coroutines.Dispatchers
import org.jetbrains.skiko.SkiaLayer
import org.w3c.dom.HTMLCanvasElement
import org.w3c.dom.HTMLElement
import robotran.uikit.*

/**
 * Compose in a canvas, with features that its own browser window lacks: multi-touch, input methods and dead keys, the
 * clipboard, an on-screen keyboard that covers nothing, and accessible HTML next to the canvas.
 *
 * @param body the parent element. The window fills it without the on-screen keyboard, notches and rounded corners.
 * @param fonts receives all texts and loads the fonts they need.
 * @param hasHistory whether the browser's Back closes dialogs and menus.
 */
@OptIn(InternalComposeUiApi::class, ExperimentalComposeUiApi::class)
internal class PageWindow(body: HTMLElement, fonts: PageFonts, hasHistory: Boolean, content: @Composable () -> Unit) {
    private val place = CanvasLayout(body)
    private val canvas = document.createElement("canvas") as HTMLCanvasElement
    private val layer = SkiaLayer()
    private val clipboard = PageClipboard(::paste)
    private val mirror: AccessibilityDom
    private val input: PageTextInput
    private var density by mutableStateOf(Density(1f))
    private var size by mutableStateOf(IntSize.Zero)
    private var keyboardHeight by mutableStateOf(0.dp)
    private var openLayers by mutableIntStateOf(0)
    private var theme by mutableStateOf(SystemTheme.Unknown)

    init {
        canvas.tabIndex = 0
        // Focused elements have their own ring.
        canvas.style.setProperty("outline", "none")
        canvas.style.setProperty("display", "block")
        place.element.appendChild(canvas)
        // Before anything handles them, and also those of the HTML beside the canvas.
        for (type in listOf("keydown", "pointerdown", "pointerup", "click", "input")) {
            place.element.addEventListener(type, { mirror.awaitChange() }, true)
        }
        input = PageTextInput(place.element, canvas) { density.density }
        mirror = AccessibilityDom(place.element, canvas, input, fonts, { density.density }) { openLayers = it }
    }

    private val scene: ComposeScene = CanvasLayersComposeScene(
        coroutineContext = Dispatchers.Main,
        composeSceneContext = object : ComposeSceneContext {
            override val platformContext: PlatformContext = PageContext()
        },
        invalidate = layer::needRedraw,
    )

    init {
        val frames = SceneFrames(scene)
        layer.renderDelegate = frames
        val keys = PageKeys(scene, frames, clipboard)
        keys.listenTo(canvas)
        input.listen(keys)
        val untaken = UntakenKeys()
        keys.listenToWindow { openLayers == 0 && untaken.take(it) }
        PagePointers(canvas, scene, frames, { density.density }) { input.keepFocus() }.listen()
        whenDarkChanges { dark -> theme = if (dark) SystemTheme.Dark else SystemTheme.Light }
        scene.setContent {
            CompositionLocalProvider(
                LocalSystemTheme provides theme,
                LocalClipboardManager provides clipboard,
                LocalClipboardReader provides clipboard,
                LocalKeyboardHeight provides keyboardHeight,
                LocalUntakenKeys provides untaken,
                LocalAddedFonts provides fonts.withEmoji,
            ) { WithAddedFonts(content) }
            if (hasHistory) CloseByBack()
        }
        place.whenChanged(::fit)
        canvas.focus()
    }

    @Composable
    private fun CloseByBack() {
        LaunchedEffect(Unit) {
            val history = PageHistory(::closeTop)
            snapshotFlow { openLayers + BackHandlers.count }.collect(history::show)
        }
    }

    /** Dialogs and menus are on top and close on Escape. */
    private fun closeTop() {
        if (openLayers == 0) {
            BackHandlers.goBack()
        } else {
            for (type in listOf(
                KeyEventType.KeyDown,
                KeyEventType.KeyUp,
            )) {
                scene.sendKeyEvent(KeyEvent(Key.Escape, type))
            }
        }
    }

    private fun fit(width: Int, height: Int, covered: Dp) {
        keyboardHeight = covered
        val scale = window.devicePixelRatio
        if (width <= 0 || height <= 0) return
        val pixels = IntSize((width * scale).toInt(), (height * scale).toInt())
        if (pixels == size && density.density == scale.toFloat()) return
        size = pixels
        density = Density(scale.toFloat())
        canvas.width = pixels.width
        canvas.height = pixels.height
        canvas.style.width = "${width}px"
        canvas.style.height = "${height}px"
        scene.density = density
        scene.size = pixels
        // After a change of its size the canvas must be attached again.
        layer.attachTo(canvas)
        layer.needRedraw()
    }

    private fun paste(text: String) = input.insert(text)

    private inner class PageContext : PlatformContext {
        override val windowInfo: WindowInfo = object : WindowInfo {
            override val isWindowFocused: Boolean get() = true
            override val containerSize: IntSize get() = size
        }
        override val inputModeManager: InputModeManager = InputModality()
        override val textInputService: PlatformTextInputService = input
        override val semanticsOwnerListener: PlatformContext.SemanticsOwnerListener = mirror
        override val viewConfiguration = object : ViewConfiguration by PlatformContext.Empty.viewConfiguration {
            override val touchSlop: Float get() = with(density) { TOUCH_SLOP.toPx() }
        }

        override fun setPointerIcon(pointerIcon: PointerIcon) {
            canvas.style.cursor = CURSORS[pointerIcon] ?: "default"
        }
    }

    private companion object {
        /** The max movement of a tap. */
        val TOUCH_SLOP = 8.dp
        val CURSORS = mapOf(
            PointerIcon.Text to "text",
            PointerIcon.Hand to "pointer",
            PointerIcon.Crosshair to "crosshair",
        )
    }
}

/** Whether touch or the keyboard was used last: touch until a key comes, as what a screen reader presses is neither. */
private class InputModality : InputModeManager {
    override var inputMode: InputMode by mutableStateOf(InputMode.Touch)
        private set

    @ExperimentalComposeUiApi
    override fun requestInputMode(inputMode: InputMode): Boolean {
        this.inputMode = inputMode
        return true
    }
}

private fun whenDarkChanges(tell: (Boolean) -> Unit): Unit = js(
    """{
        const dark = matchMedia('(prefers-color-scheme: dark)');
        dark.addEventListener('change', () => tell(dark.matches));
        tell(dark.matches);
    }""",
)
