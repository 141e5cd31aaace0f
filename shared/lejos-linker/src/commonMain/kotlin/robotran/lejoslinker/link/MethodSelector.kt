package robotran.lejoslinker.link

import robotran.lejoslinker.config.ImageLimits
import robotran.lejoslinker.messages.ImageMessages
import robotran.lejoslinker.messages.tinyVm
import robotran.tinyvm.classfile.AccessFlag
import robotran.tinyvm.classfile.Constant
import robotran.tinyvm.classfile.DamagedClassFile
import robotran.tinyvm.classfile.MethodDescriptor
import robotran.tinyvm.classfile.MethodEntry
import robotran.tinyvm.messages.Counted
import robotran.tinyvm.messages.UnsupportedFeature

/**
 * Selects the methods that get into an image, and numbers their signatures. A method stays if it is used, or, as with
 * leJOS's linker, if any class names its name and descriptor, whatever class is meant. Source: leJOS `Binary.java`,
 * markMethods, and `ClassRecord.java`.
 */
internal class MethodSelector(
    private val classes: List<ImageClass>,
    private val signatures: SignatureTable,
    private val errors: ErrorList,
    private val messages: ImageMessages,
) {
    fun select(keepsAll: Boolean, used: UsedParts?) {
        val named = if (keepsAll || used != null) emptySet() else classes.flatMapTo(HashSet()) { namedIn(it) }
        for (each in classes) {
            val kept = each.file.methods.filter {
                when {
                    keepsAll -> true
                    used != null -> used.has(it)
                    else -> each.isEntry || it.name.startsWith("<") || it.signature == RUN || it.signature in named
                }
            }
            each.methods = kept.mapIndexed { index, entry ->
                ImageMethod(
                    each,
                    index,
                    entry,
                    signatures.numberOf(entry.signature),
                    MethodDescriptor.of(entry.descriptor),
                ).also(::check)
            }
            limit(kept.size, ImageLimits.METHODS, Counted.METHODS, CodePlace(each.name))
            if (each.isEntry && kept.none(::isMain)) {
                errors.add(CodePlace(each.name), messages.tinyVm.noMainMethod())
            }
        }
        val count = signatures.all.size
        if (count > ImageLimits.SIGNATURES) {
            val place = CodePlace(classes.firstOrNull { it.isEntry }?.name.orEmpty())
            errors.add(place, messages.tooManySignatures(count, ImageLimits.SIGNATURES))
        }
    }

    private fun namedIn(each: ImageClass): List<String> = try {
        val constants = each.file.constants
        constants.all.filterIsInstance<Constant.NameAndType>().map {
            constants.text(it.nameIndex) + constants.text(it.descriptorIndex)
        }
    } catch (_: DamagedClassFile) {
        errors.add(CodePlace(each.name), messages.tinyVm.classFileDamaged())
        emptyList()
    }

    private fun isMain(entry: MethodEntry) = entry.signature == MAIN && entry.flags and AccessFlag.STATIC != 0

    private fun check(method: ImageMethod) {
        val place = method.place
        limit(method.parameterWords, ImageLimits.PARAMETER_WORDS, Counted.PARAMETERS, place)
        if (method.isNative && !SignatureTable.isNative(method.signature)) {
            errors.add(place, messages.tinyVm.nativeMethod(method.entry.name))
        }
        val body = method.body ?: return
        limit(body.maxLocals, ImageLimits.LOCALS, Counted.LOCALS, place)
        limit(body.maxStack, ImageLimits.OPERANDS, Counted.OPERANDS, place)
        limit(body.handlers.size, ImageLimits.HANDLERS, Counted.HANDLERS, place)
        if (method.owner.file.isInterface && !method.isStatic) {
            errors.add(place, messages.tinyVm.unsupportedFeature(UnsupportedFeature.INTERFACE_CODE))
        }
    }

    private fun limit(count: Int, max: Int, counted: Counted, place: CodePlace) {
        if (count > max) errors.add(place, messages.tinyVm.tooMany(counted, max))
    }

    companion object {
        private const val RUN = "run()V"

        /** The signature of the method that a brick starts. */
        const val MAIN = "main([Ljava/lang/String;)V"
    }
}
