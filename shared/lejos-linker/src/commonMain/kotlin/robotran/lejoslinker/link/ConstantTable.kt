package robotran.lejoslinker.link

import robotran.lejoslinker.image.ConstantValue
import robotran.lejoslinker.messages.ImageMessages
import robotran.lejoslinker.messages.tinyVm
import robotran.tinyvm.classfile.Constant
import robotran.tinyvm.classfile.ConstantPool
import robotran.tinyvm.classfile.DamagedClassFile

/**
 * Numbers the texts and numbers that the classes of an image have among their constants, used or not, or only those that
 * are used. Source: leJOS `Binary.java`, processConstants.
 */
internal class ConstantTable(
    classes: List<ImageClass>,
    errors: ErrorList,
    messages: ImageMessages,
    used: UsedParts? = null,
) {
    private val numbers = LinkedHashMap<ConstantValue, Int>()

    /** All constants by number. */
    val all: List<ConstantValue> get() = numbers.keys.toList()

    init {
        used?.constants?.forEach { numbers[it] = numbers.size }
        for (each in if (used == null) classes else emptyList()) {
            try {
                for (constant in each.file.constants.all) {
                    valueOf(constant, each.file.constants)?.let { value -> numbers.getOrPut(value) { numbers.size } }
                }
            } catch (_: DamagedClassFile) {
                errors.add(CodePlace(each.name), messages.tinyVm.classFileDamaged())
            }
        }
    }

    val size: Int get() = numbers.size

    fun numberOf(value: ConstantValue): Int = numbers.getValue(value)

    companion object {
        /** The value of [constant]; null if it is neither text nor number. */
        fun valueOf(constant: Constant, pool: ConstantPool): ConstantValue? = when (constant) {
            is Constant.StringText -> ConstantValue.Text(pool.string(constant))
            is Constant.Whole -> ConstantValue.Whole(constant.value)
            is Constant.Decimal -> ConstantValue.Decimal(constant.value.toBits())
            is Constant.Long -> ConstantValue.LongWhole(constant.value)
            is Constant.Double -> ConstantValue.LongDecimal(constant.value.toBits())
            else -> null
        }
    }
}
