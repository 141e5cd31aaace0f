@file:OptIn(ExperimentalWasmJsInterop::class)

package robotran.web

/** The browser's sounds, as much as a [WebSpeaker] needs of the Web Audio API. Times are in seconds. */
internal external class AudioContext : JsAny {
    val currentTime: Double
    val destination: AudioNode
    val state: String

    fun resume(): JsAny

    fun close(): JsAny

    fun createOscillator(): OscillatorNode

    fun createGain(): GainNode
}

internal open external class AudioNode : JsAny {
    fun connect(destination: AudioNode): AudioNode

    fun disconnect()
}

internal external class OscillatorNode : AudioNode {
    var type: String
    val frequency: AudioParam

    fun start(time: Double)

    fun stop(time: Double)
}

internal external class GainNode : AudioNode {
    val gain: AudioParam
}

internal external class AudioParam : JsAny {
    var value: Float

    fun setValueAtTime(value: Float, time: Double): AudioParam

    fun linearRampToValueAtTime(value: Float, time: Double): AudioParam

    fun cancelScheduledValues(time: Double): AudioParam
}

/** A context, or null in a browser that has none. */
internal fun newAudioContext(): AudioContext? =
    js("globalThis.AudioContext ? new AudioContext({ latencyHint: 'interactive' }) : null")

/** Calls [action] at every touch, click and key of the page: only then a browser lets a page make sounds. */
internal fun onEveryTouch(action: () -> Unit): Unit = js(
    "{ for (const kind of ['pointerup', 'touchend', 'keydown']) addEventListener(kind, () => action(), { capture: " +
        "true }); }",
)
