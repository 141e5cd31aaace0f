package robotran.tinyvm.link

import robotran.tinyvm.classfile.Constant
import robotran.tinyvm.classfile.FieldEntry
import robotran.tinyvm.classfile.wordsOf
import robotran.tinyvm.config.MachineModel
import robotran.tinyvm.config.TinyVmLimits
import robotran.tinyvm.messages.Counted
import robotran.tinyvm.messages.LinkMessages
import robotran.tinyvm.messages.UnsupportedFeature

/** Assigns slots and indices to the fields and methods of classes. */
internal class MemberTable(private val messages: LinkMessages, private val model: MachineModel) {
    private val allMethods = ArrayList<LinkedMethod>()
    private val allStatics = ArrayList<LinkedField>()
    private val signatureNumbers =
        SpecialNumbers.SIGNATURES.withIndex().associateTo(HashMap<String, Int>()) { it.value to it.index }
    private val interfaceNumbers = HashMap<String, Int>()

    /** The methods with a number: on an exact machine those that can be called. */
    val methods: List<LinkedMethod> get() = allMethods

    /** The static fields of all classes, in the order of their slots. */
    val statics: List<LinkedField> get() = allStatics

    /** The words of all static fields. */
    var staticWords = 0
        private set

    /** The index in [HeapType.interfaceMethods] of the interface method with this [signature]. */
    fun interfaceNumber(signature: String): Int = interfaceNumbers.getOrPut(signature) { interfaceNumbers.size }

    /** Lays out the members of [linked]; its superclass must be laid out already. */
    fun place(linked: LinkedClass) {
        val file = linked.file
        val place = CodeLocation(file.name)
        if (file.fields.size > TinyVmLimits.FIELDS) place.reject(messages.tooMany(Counted.FIELDS, TinyVmLimits.FIELDS))
        if (file.methods.size > TinyVmLimits.METHODS) {
            place.reject(messages.tooMany(Counted.METHODS, TinyVmLimits.METHODS))
        }
        placeFields(linked)
        placeMethods(linked, place)
    }

    /** Fills [HeapType.interfaceMethods] of [classes]; all interface methods must have numbers by then. */
    fun completeInterfaces(classes: List<LinkedClass>) {
        for (linked in classes) {
            val methods = arrayOfNulls<LinkedMethod>(interfaceNumbers.size)
            for (method in linked.virtualMethods) interfaceNumbers[method.signature]?.let { methods[it] = method }
            linked.interfaceMethods = methods
        }
    }

    private fun placeFields(linked: LinkedClass) {
        var words = linked.superclass?.fieldWords ?: 0
        var bytes = linked.superclass?.brickBytes ?: BRICK_HEADER_BYTES
        val references = linked.superclass?.referenceWords?.toMutableList() ?: mutableListOf()
        linked.fields = linked.file.fields.map { entry ->
            val slot = if (entry.isStatic) staticWords else words
            val taken = if (model.isExact) wordsOf(entry.descriptor) else 1
            if (entry.isStatic) staticWords += taken else words += taken
            val value = initialValue(linked, entry)
            val field = LinkedField(linked, entry.name, entry.descriptor, entry.isStatic, slot, value)
            if (entry.isStatic) allStatics += field else bytes += brickBytesOf(entry.descriptor)
            if (!entry.isStatic && field.isReference) references += field.slot
            field
        }
        linked.fieldWords = words
        linked.referenceWords = references.toIntArray()
        linked.brickBytes = bytes
    }

    private fun initialValue(linked: LinkedClass, entry: FieldEntry): InitialValue? {
        if (entry.constantIndex == 0 || !entry.isStatic) return null
        val constants = linked.file.constants
        return when (val constant = constants.constant(entry.constantIndex)) {
            is Constant.Whole -> InitialValue.Word(constant.value)
            is Constant.Decimal -> InitialValue.Word(constant.value.toBits())
            is Constant.Long -> wide(constant.value, constant.value.toInt())
            is Constant.Double -> wide(constant.value.toBits(), constant.value.toFloat().toBits())

            is Constant.StringText -> InitialValue.Text(constants.string(constant)).takeIf {
                entry.descriptor == "Ljava/lang/String;"
            }

            else -> null
        }.takeIf { it !is InitialValue.Word || !isReferenceDescriptor(entry.descriptor) }
    }

    private fun wide(value: Long, wordOnRcx: Int): InitialValue =
        if (model.isExact) InitialValue.Wide(value) else InitialValue.Word(wordOnRcx)

    private fun placeMethods(linked: LinkedClass, location: CodeLocation) {
        val virtual = linked.superclass?.virtualMethods.orEmpty().toMutableList()
        linked.methods = linked.file.methods.map { entry ->
            val signature = signatureNumbers.getOrPut(entry.name + entry.descriptor) { signatureNumbers.size }
            val method = LinkedMethod(linked, entry, signature)
            if (!model.isExact) number(method)
            if (method.argumentWords > TinyVmLimits.PARAMETERS) {
                CodeLocation(
                    linked.name,
                    method.name,
                ).reject(messages.tooMany(Counted.PARAMETERS, TinyVmLimits.PARAMETERS))
            }
            if (linked.isInterface && entry.code != null && entry.name != "<clinit>") {
                location.reject(messages.unsupportedFeature(UnsupportedFeature.INTERFACE_CODE))
            }
            if (!method.isStatic && !method.isConstructor && !linked.isInterface) placeVirtual(method, virtual)
            method
        }
        linked.virtualMethods = virtual
    }

    /** Gives [method] the next number. */
    fun number(method: LinkedMethod) {
        method.number = allMethods.size
        allMethods += method
    }

    private fun placeVirtual(method: LinkedMethod, virtual: MutableList<LinkedMethod>) {
        val overridden = virtual.indexOfFirst { it.signature == method.signature && !it.isPrivate }
        method.virtualIndex = if (overridden >= 0) overridden else virtual.size
        if (overridden >= 0) virtual[overridden] = method else virtual += method
    }

    private companion object {
        /** Source: leJOS `memory.h`, HEADER_SIZE. */
        const val BRICK_HEADER_BYTES = 4
    }
}
