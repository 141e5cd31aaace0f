package robotran.android.platform

import android.graphics.Bitmap
import android.graphics.BitmapFactory
import android.graphics.Canvas
import android.graphics.Color
import android.graphics.Matrix
import android.graphics.Paint
import android.graphics.Rect
import android.media.ExifInterface
import robotran.workshop.platform.Photo
import robotran.workshop.platform.PhotoReader
import java.io.ByteArrayOutputStream
import java.io.IOException

/** Reads photos with Android, which knows those of most phones, HEIC too. */
object AndroidPhotoReader : PhotoReader {
    override suspend fun read(bytes: ByteArray): Photo? {
        val bounds = BitmapFactory.Options().apply { inJustDecodeBounds = true }
        BitmapFactory.decodeByteArray(bytes, 0, bytes.size, bounds)
        val options = BitmapFactory.Options().apply { inSampleSize = 1 }
        while (maxOf(bounds.outWidth, bounds.outHeight) / (options.inSampleSize * 2) >= MIN_SIDE) {
            options.inSampleSize *= 2
        }
        val picture = BitmapFactory.decodeByteArray(bytes, 0, bytes.size, options) ?: return null
        val turn = turnOf(bytes) ?: return AndroidPhoto(picture)
        return AndroidPhoto(Bitmap.createBitmap(picture, 0, 0, picture.width, picture.height, turn, true))
    }

    /** How to turn the picture upright; null for not at all. Android turns all but JPEG itself. */
    private fun turnOf(bytes: ByteArray): Matrix? {
        if (bytes.size < 2 || bytes[0] != JPEG_FIRST || bytes[1] != JPEG_SECOND) return null
        val orientation = try {
            ExifInterface(bytes.inputStream())
                .getAttributeInt(ExifInterface.TAG_ORIENTATION, ExifInterface.ORIENTATION_NORMAL)
        } catch (_: IOException) {
            return null
        }
        return when (orientation) {
            ExifInterface.ORIENTATION_FLIP_HORIZONTAL -> turn(0f, mirrored = true)
            ExifInterface.ORIENTATION_ROTATE_180 -> turn(180f)
            ExifInterface.ORIENTATION_FLIP_VERTICAL -> turn(180f, mirrored = true)
            ExifInterface.ORIENTATION_TRANSPOSE -> turn(90f, mirrored = true)
            ExifInterface.ORIENTATION_ROTATE_90 -> turn(90f)
            ExifInterface.ORIENTATION_TRANSVERSE -> turn(270f, mirrored = true)
            ExifInterface.ORIENTATION_ROTATE_270 -> turn(270f)
            else -> null
        }
    }

    private fun turn(degrees: Float, mirrored: Boolean = false) = Matrix().apply {
        postRotate(degrees)
        if (mirrored) postScale(-1f, 1f)
    }

    /** More than an assignment needs. */
    private const val MIN_SIDE = 1600
    private const val JPEG_FIRST = 0xFF.toByte()
    private const val JPEG_SECOND = 0xD8.toByte()
}

private class AndroidPhoto(private val picture: Bitmap) : Photo {
    override val width: Int get() = picture.width
    override val height: Int get() = picture.height

    override suspend fun jpeg(width: Int, height: Int, quality: Int): ByteArray {
        val smaller = Bitmap.createBitmap(width, height, Bitmap.Config.ARGB_8888)
        val canvas = Canvas(smaller)
        canvas.drawColor(Color.WHITE)
        canvas.drawBitmap(picture, null, Rect(0, 0, width, height), Paint(Paint.FILTER_BITMAP_FLAG))
        val bytes = ByteArrayOutputStream()
        smaller.compress(Bitmap.CompressFormat.JPEG, quality, bytes)
        smaller.recycle()
        return bytes.toByteArray()
    }

    override fun close() = picture.recycle()
}
