package robotran.nqc.api

import robotran.legofirmware.image.FirmwareTarget
import robotran.nqc.config.ParameterLimit

/**
 * What messages say about the names of the API.
 *
 * @param isOld whether it is that of NQC 1.3.
 */
internal class ApiNames(private val target: FirmwareTarget, private val isOld: Boolean) {
    /** Whether [name] exists for firmware 2.0 only, which is not the target. */
    fun needsSecondFirmware(name: String): Boolean =
        target == FirmwareTarget.RCX && !isOld && name in NqcApi.of(FirmwareTarget.RCX2)

    /** How the function [name] is called, without the semicolon; null if it is not part of the API. */
    fun callOf(name: String): String? = NqcApi.of(target, isOld)[name]?.let { it.usualCall ?: it.signature }
}

/** A call such as `OnFwd(OUT_A)`; null if there are no arguments, or none that are more usual than others. */
val NqcApiEntry.usualCall: String?
    get() {
        val arguments = parameters.orEmpty().indices.map { argumentOf(this, it) }
        return if (arguments.isEmpty() || null in arguments) null else arguments.joinToString(", ", "$name(", ")")
    }

private fun argumentOf(entry: NqcApiEntry, number: Int): String? {
    ExpectedNames.of(entry, number).firstOrNull()?.let { return it }
    val limit = (entry.definition as? ApiDefinition.Function)?.limits?.getOrNull(number)
    return NUMBERS[limit]
}

private val NUMBERS = mapOf(
    ParameterLimit.WAIT to "100",
    ParameterLimit.FREQUENCY to "440",
    ParameterLimit.TONE_TIME to "50",
    ParameterLimit.MESSAGE to "1",
    ParameterLimit.ENTRIES to "100",
)
