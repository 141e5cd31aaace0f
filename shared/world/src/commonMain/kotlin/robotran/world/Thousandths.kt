package robotran.world

import kotlin.jvm.JvmInline
import kotlin.math.abs
import kotlin.math.floor
import kotlinx.serialization.ExperimentalSerializationApi
import kotlinx.serialization.KSerializer
import kotlinx.serialization.Serializable
import kotlinx.serialization.descriptors.PrimitiveKind
import kotlinx.serialization.descriptors.PrimitiveSerialDescriptor
import kotlinx.serialization.encoding.Decoder
import kotlinx.serialization.encoding.Encoder
import kotlinx.serialization.json.JsonEncoder
import kotlinx.serialization.json.JsonUnquotedLiteral

/** A number with three decimals, kept as a whole number of thousandths, since the platforms do not write every `Double` alike. */
@Serializable(with = ThousandthsSerializer::class)
@JvmInline
value class Thousandths(val count: Long) {
    val value: Double get() = count / SCALE

    /** Such as `20.0`, `-0.125` or `79.96`: no more decimals than needed, but at least one. */
    override fun toString(): String {
        val size = abs(count)
        val decimals = (size % WHOLE).toString().padStart(DECIMALS, '0').trimEnd('0').ifEmpty { "0" }
        return (if (count < 0) "-" else "") + "${size / WHOLE}.$decimals"
    }

    companion object {
        private const val SCALE = 1000.0
        private const val WHOLE = 1000L
        private const val DECIMALS = 3
        private const val HALF = 0.5

        /** The nearest number with three decimals. */
        fun of(number: Double): Thousandths = Thousandths(floor(number * SCALE + HALF).toLong())
    }
}

/** A JSON number, written digit by digit as [Thousandths.toString] does. */
internal object ThousandthsSerializer : KSerializer<Thousandths> {
    override val descriptor = PrimitiveSerialDescriptor("robotran.world.Thousandths", PrimitiveKind.DOUBLE)

    @OptIn(ExperimentalSerializationApi::class)
    override fun serialize(encoder: Encoder, value: Thousandths) {
        if (encoder is JsonEncoder) encoder.encodeJsonElement(JsonUnquotedLiteral(value.toString())) else encoder.encodeDouble(value.value)
    }

    override fun deserialize(decoder: Decoder): Thousandths = Thousandths.of(decoder.decodeDouble())
}
