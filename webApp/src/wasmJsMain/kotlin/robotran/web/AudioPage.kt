@file:OptIn(ExperimentalWasmJsInterop::class)

package robotran.web

/** The parts of the Web Audio API that [WebSpeaker] needs. Times are in seconds. */
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

internal external class StereoPannerNode : AudioNode {
    val pan: AudioParam
}

internal external class AudioParam : JsAny {
    var value: Float

    fun setValueAtTime(value: Float, time: Double): AudioParam

    fun linearRampToValueAtTime(value: Float, time: Double): AudioParam

    fun cancelScheduledValues(time: Double): AudioParam
}

/** A context; null if the browser does not support Web Audio. */
internal fun newAudioContext(): AudioContext? =
    js("globalThis.AudioContext ? new AudioContext({ latencyHint: 'interactive' }) : null")

/** A node that puts sound between the ears; null in a browser without one. */
internal fun newStereoPanner(context: AudioContext): StereoPannerNode? =
    js("context.createStereoPanner ? context.createStereoPanner() : null")

/** Calls [action] on every touch, click and key press of the page: browsers allow sound only after one. */
internal fun onEveryTouch(action: () -> Unit): Unit = js(
    "{ for (const kind of ['pointerup', 'touchend', 'keydown']) addEventListener(kind, () => action(), { capture: " +
        "true }); }",
)
