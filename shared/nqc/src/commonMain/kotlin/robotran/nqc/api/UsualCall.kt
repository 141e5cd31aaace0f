package robotran.nqc.api

import robotran.legofirmware.image.FirmwareTarget
import robotran.nqc.config.ParameterLimit
import robotran.nqc.parse.ApiNames

/** What messages say about the API for [target]; about that of NQC 1.3 if [isOld]. */
internal fun apiNames(target: FirmwareTarget, isOld: Boolean): ApiNames {
    val api = NqcApi.of(target, isOld)
    val second = if (target == FirmwareTarget.RCX && !isOld) NqcApi.of(FirmwareTarget.RCX2).keys else emptySet()
    return ApiNames({ it in second }, { name -> api[name]?.let { it.usualCall ?: it.signature } })
}

/** A call such as `OnFwd(OUT_A)`; null if there are no arguments, or none that are more usual than others. */
val NqcApiEntry.usualCall: String?
    get() {
        val arguments = parameters.orEmpty().indices.map { argumentOf(this, it) }
        return if (arguments.isEmpty() || null in arguments) null else arguments.joinToString(", ", "$name(", ")")
    }

private fun argumentOf(entry: NqcApiEntry, number: Int): String? {
    ExpectedNames.of(entry, number).firstOrNull()?.let { return it }
    val limit = entry.function?.limits?.getOrNull(number)
    return NUMBERS[limit]
}

private val NUMBERS = mapOf(
    ParameterLimit.WAIT to "100",
    ParameterLimit.FREQUENCY to "440",
    ParameterLimit.TONE_TIME to "50",
    ParameterLimit.MESSAGE to "1",
    ParameterLimit.ENTRIES to "100",
)
