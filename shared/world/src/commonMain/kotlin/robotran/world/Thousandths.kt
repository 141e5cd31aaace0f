package robotran.world

import kotlinx.serialization.ExperimentalSerializationApi
import kotlinx.serialization.KSerializer
import kotlinx.serialization.Serializable
import kotlinx.serialization.descriptors.PrimitiveKind
import kotlinx.serialization.descriptors.PrimitiveSerialDescriptor
import kotlinx.serialization.encoding.Decoder
import kotlinx.serialization.encoding.Encoder
import kotlinx.serialization.json.JsonEncoder
import kotlinx.serialization.json.JsonUnquotedLiteral
import kotlin.math.abs
import kotlin.math.floor

/** A number with at most three decimals in JSON. */
typealias Thousandths =
    @Serializable(with = ThousandthsSerializer::class)
    Double

/** [number] in thousandths, rounded to the nearest. */
fun thousandthsIn(number: Double): Long = floor(number * THOUSAND + HALF).toLong()

/** [number] rounded to three decimals. */
fun roundToThousandths(number: Double): Double = thousandthsIn(number) / THOUSAND

/** Such as `20.0`, `-0.125` or `79.96`: as few decimals as needed, but at least one. */
fun writeThousandths(number: Double): String {
    val count = thousandthsIn(number)
    val size = abs(count)
    val decimals = (size % WHOLE).toString().padStart(DECIMALS, '0').trimEnd('0').ifEmpty { "0" }
    return (if (count < 0) "-" else "") + "${size / WHOLE}.$decimals"
}

/** Writes numbers digit by digit, because platforms format `Double` differently. */
internal object ThousandthsSerializer : KSerializer<Double> {
    override val descriptor = PrimitiveSerialDescriptor("robotran.world.Thousandths", PrimitiveKind.DOUBLE)

    @OptIn(ExperimentalSerializationApi::class)
    override fun serialize(encoder: Encoder, value: Double) {
        if (encoder is JsonEncoder) {
            encoder.encodeJsonElement(JsonUnquotedLiteral(writeThousandths(value)))
        } else {
            encoder.encodeDouble(value)
        }
    }

    override fun deserialize(decoder: Decoder): Double = decoder.decodeDouble()
}

private const val THOUSAND = 1000.0
private const val WHOLE = 1000L
private const val DECIMALS = 3
private const val HALF = 0.5
