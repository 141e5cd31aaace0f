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

/** A number that is written to JSON with at most three decimals. */
typealias Thousandths =
    @Serializable(with = ThousandthsSerializer::class)
    Double

/** How many thousandths are nearest to [number]. */
fun thousandthsIn(number: Double): Long = floor(number * THOUSAND + HALF).toLong()

/** The number with three decimals that is nearest to [number]. */
fun roundToThousandths(number: Double): Double = thousandthsIn(number) / THOUSAND

/** Such as `20.0`, `-0.125` or `79.96`: no more decimals than needed, but at least one. */
fun writeThousandths(number: Double): String {
    val count = thousandthsIn(number)
    val size = abs(count)
    val decimals = (size % WHOLE).toString().padStart(DECIMALS, '0').trimEnd('0').ifEmpty { "0" }
    return (if (count < 0) "-" else "") + "${size / WHOLE}.$decimals"
}

/** Writes numbers digit by digit, since the platforms do not write every `Double` alike. */
internal object ThousandthsSerializer : KSerializer<Double> {
    override val descriptor = PrimitiveSerialDescriptor("robotran.world.Thousandths", PrimitiveKind.DOUBLE)

    @OptIn(ExperimentalSerializationApi::class)
    override fun serialize(encoder: Encoder, value: Double) {
        if (encoder is JsonEncoder) {
            encoder.encodeJsonElement(
                JsonUnquotedLiteral(writeThousandths(value)),
            )
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
