package robotran.lejoslinker.link

import robotran.lejoslinker.config.ByteOrder
import robotran.lejoslinker.image.ByteSink
import robotran.lejoslinker.image.PartKind

/**
 * Writes the bytes of an image, part by part. Source: leJOS `Binary.java` and the `dump` functions of its records; for
 * the flags `classes.h` and `language.h`.
 */
internal class ImageWriter(private val layout: ImageLayout, order: ByteOrder) {
    private val sink = ByteSink(layout.size, order)
    private var exceptions = layout.offsetOf(PartKind.EXCEPTION_RECORDS)

    fun write(): ByteArray {
        masterRecord()
        classRecords()
        repeat(layout.staticWords) { sink.short(0) }
        layout.staticFields.forEach { sink.short(it.type.number shl OFFSET_BITS or it.offset) }
        constantRecords()
        layout.methods.forEach(::methodRecord)
        layout.methods.forEach(::exceptionRecords)
        layout.classes.forEach { each -> each.instanceFields.forEach { sink.byte(it.type.number) } }
        layout.methods.forEach { sink.all(it.code) }
        layout.constants.forEach { sink.all(it.bytes) }
        layout.entryClasses.forEach(sink::byte)
        return sink.bytes
    }

    private fun masterRecord() = with(sink) {
        short(MAGIC)
        short(layout.offsetOf(PartKind.CONSTANT_RECORDS))
        short(layout.offsetOf(PartKind.STATIC_FIELD_RECORDS))
        short(layout.offsetOf(PartKind.STATIC_STATE))
        short(layout.staticWords)
        short(layout.staticFields.size)
        short(layout.offsetOf(PartKind.ENTRY_CLASSES))
        byte(layout.entryClasses.size)
        byte(layout.classes.size - 1)
    }

    private fun classRecords() {
        var methods = layout.offsetOf(PartKind.METHOD_RECORDS)
        var fields = layout.offsetOf(PartKind.FIELD_TYPES)
        for (each in layout.classes) {
            with(sink) {
                short(each.objectWords)
                short(methods)
                short(fields)
                byte(each.instanceFields.size)
                byte(each.methods.size)
                byte(each.superclass?.number ?: 0)
                byte(
                    flag(each.hasInitializer, HAS_INITIALIZER) or flag(each.file.isInterface, IS_INTERFACE),
                )
            }
            methods += each.methods.size * ImageLayout.METHOD_RECORD
            fields += each.instanceFields.size
        }
    }

    private fun constantRecords() {
        var offset = layout.offsetOf(PartKind.CONSTANT_VALUES)
        for (constant in layout.constants) {
            val length = constant.bytes.size
            sink.short(offset)
            sink.byte(constant.type.number)
            sink.byte(length)
            offset += length
        }
    }

    private fun methodRecord(method: ImageMethod) = with(sink) {
        val body = method.body
        short(method.signature)
        short(if (body == null) 0 else exceptions)
        short(layout.codeOffsetOf(method))
        byte(body?.maxLocals ?: 0)
        byte(body?.maxStack ?: 0)
        byte(method.parameterWords)
        byte(body?.handlers?.size ?: 0)
        byte(
            flag(method.isNative, IS_NATIVE) or flag(method.isSynchronized, IS_SYNCHRONIZED) or
                flag(method.isStatic, IS_STATIC),
        )
        byte(0)
        exceptions += (body?.handlers?.size ?: 0) * ImageLayout.EXCEPTION_RECORD
    }

    private fun exceptionRecords(method: ImageMethod) {
        for (handler in method.body?.handlers.orEmpty()) {
            sink.short(handler.start)
            sink.short(handler.end)
            sink.short(handler.target)
            sink.byte(handler.catchType?.let { layout.hierarchy.classNamed(it)?.number } ?: THROWABLE)
            sink.byte(0)
        }
    }

    private fun flag(isSet: Boolean, bit: Int) = if (isSet) bit else 0

    private companion object {
        const val MAGIC = 0xCAF6
        const val OFFSET_BITS = 12
        const val HAS_INITIALIZER = 4
        const val IS_INTERFACE = 8
        const val IS_NATIVE = 1
        const val IS_SYNCHRONIZED = 2
        const val IS_STATIC = 4

        /** The class that a handler of `finally` catches. */
        const val THROWABLE = 3
    }
}
