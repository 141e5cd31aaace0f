@file:OptIn(ExperimentalWasmJsInterop::class)

package robotran.web.platform

import kotlinx.coroutines.delay
import robotran.animatedpicture.ChangedArea
import robotran.animatedpicture.FrameSource
import robotran.animatedpicture.changedArea
import robotran.web.device.JsBytes
import robotran.web.device.outcome
import robotran.web.device.toByteArray
import robotran.workshop.platform.VideoRecorder
import kotlin.js.Promise

/**
 * Films a canvas with the browser's `MediaRecorder`, in real time. Frames that come too late are left out, so the video
 * has the right speed on a slow machine, too.
 */
internal object WebVideoRecorder : VideoRecorder {
    override val isAvailable: Boolean = canRecord()

    override suspend fun record(source: FrameSource, onFrame: (Int) -> Unit): ByteArray? {
        val camera = newCamera(source.width, source.height, BITS_PER_SECOND) ?: return null
        try {
            play(source, camera, onFrame)
            delay(REST_MILLISECONDS)
            takeFrame(camera)
            return finish(camera).outcome().value?.toByteArray()?.takeIf { it.isNotEmpty() }
        } catch (_: JsException) {
            // The browser has given up, such as for lack of memory.
            return null
        } finally {
            stop(camera)
        }
    }

    private suspend fun play(source: FrameSource, camera: Camera, onFrame: (Int) -> Unit) {
        val pixels = IntArray(source.width * source.height)
        val shown = IntArray(pixels.size)
        val start = milliseconds()
        for (index in 0..<source.count) {
            val due = start + index * source.frameMilliseconds
            delay((due - milliseconds()).toLong().coerceAtLeast(1))
            val isLate = milliseconds() > due + source.frameMilliseconds
            if (isLate && index in 1..<source.count - 1) continue
            source.draw(index, pixels)
            val whole = ChangedArea(0, 0, source.width, source.height)
            val area = if (index == 0) whole else changedArea(shown, pixels, source.width)
            if (area != null) {
                put(area, pixels, source.width, camera)
                pixels.copyInto(shown)
            }
            takeFrame(camera)
            onFrame(index + 1)
        }
    }

    private fun put(area: ChangedArea, pixels: IntArray, width: Int, camera: Camera) {
        for (row in area.top..<area.bottom) {
            for (place in row * width + area.left..<row * width + area.right) setPixel(camera, place, pixels[place])
        }
        show(camera, area.left, area.top, area.width, area.height)
    }

    /** Enough for sharp lines. */
    private const val BITS_PER_SECOND = 4_000_000

    /** Gives the recorder time for the last frame. */
    private const val REST_MILLISECONDS = 1_500L
}

/** A canvas, its pixels, and what records it. */
private external interface Camera : JsAny

private fun canRecord(): Boolean = js(
    """typeof MediaRecorder === 'function' && MediaRecorder.isTypeSupported('video/webm') &&
        typeof HTMLCanvasElement.prototype.captureStream === 'function'""",
)

/** Starts to record; null if the browser refuses. */
private fun newCamera(width: Int, height: Int, bitsPerSecond: Int): Camera? = js(
    """{
        try {
            const canvas = document.createElement('canvas');
            canvas.width = width;
            canvas.height = height;
            const context = canvas.getContext('2d', { alpha: false });
            const image = context.createImageData(width, height);
            const stream = canvas.captureStream(0);
            const options = { mimeType: 'video/webm', videoBitsPerSecond: bitsPerSecond };
            const recorder = new MediaRecorder(stream, options);
            const parts = [];
            recorder.addEventListener('dataavailable', (event) => event.data.size && parts.push(event.data));
            recorder.start();
            const pixels = new Uint32Array(image.data.buffer);
            return { context, image, pixels, recorder, parts, stream, track: stream.getVideoTracks()[0] };
        } catch {
            return null;
        }
    }""",
)

/** The canvas has red in the lowest byte. */
private fun setPixel(camera: Camera, place: Int, colour: Int): Unit = js(
    """{
        camera.pixels[place] = 0xff000000 | (colour & 0xff) << 16 | colour & 0xff00 | colour >> 16 & 0xff;
    }""",
)

private fun show(camera: Camera, left: Int, top: Int, width: Int, height: Int): Unit =
    js("camera.context.putImageData(camera.image, 0, 0, left, top, width, height)")

/** Firefox has the function at the stream. */
private fun takeFrame(camera: Camera): Unit =
    js("(camera.track.requestFrame ? camera.track : camera.stream).requestFrame()")

/** Ends the recording; the file. */
private fun finish(camera: Camera): Promise<JsBytes> = js(
    """new Promise((resolve, reject) => {
        camera.recorder.addEventListener('error', (event) => reject(event.error));
        camera.recorder.addEventListener('stop', () =>
            new Blob(camera.parts).arrayBuffer().then((buffer) => resolve(new Uint8Array(buffer)), reject));
        camera.recorder.stop();
    })""",
)

private fun stop(camera: Camera): Unit = js(
    """{
        if (camera.recorder.state !== 'inactive') camera.recorder.stop();
        camera.track.stop();
    }""",
)

/** A clock that is never set. */
private fun milliseconds(): Double = js("performance.now()")
