package robotran.lejoslinker.messages

import robotran.lejoslinker.image.PartKind
import robotran.tinyvm.messages.SpanishTinyVmMessages

object SpanishImageMessages : ImageMessages {
    override val tinyVm get() = SpanishTinyVmMessages
    override val listing: ListingMessages get() = SpanishListingMessages

    override fun tooManyClasses(count: Int, limit: Int) =
        "Este programa necesita $count clases, contando las de leJOS. Un ladrillo admite como mucho $limit: usa menos."

    override fun tooManyPrograms(count: Int, limit: Int) =
        "Son $count programas. Un ladrillo admite como mucho $limit a la vez: quita algunos."

    override fun tooManyConstants(count: Int, limit: Int) =
        "Este programa tiene $count textos y números grandes distintos, contando los de leJOS. Un ladrillo solo " +
            "llega a los primeros $limit: usa menos textos. Los números enteros de -32768 a 32767 no cuentan."

    override fun tooManyStaticFields(count: Int, limit: Int) =
        "Este programa tiene $count campos static, contando los de leJOS. Un ladrillo solo llega a los primeros " +
            "$limit: usa menos, o guarda los valores en un array."

    override fun tooManyStaticBytes(count: Int, limit: Int) =
        "Los campos static de este programa ocupan $count bytes. Un ladrillo solo llega a $limit: usa menos, o " +
            "guarda los valores en un array."

    override fun tooManySignatures(count: Int, limit: Int) =
        "Este programa tiene $count métodos con distinto nombre o distintos parámetros. Un ladrillo admite como " +
            "mucho $limit: usa menos."

    override fun objectTooLarge(bytes: Int, limit: Int) =
        "Los campos de esta clase ocupan $bytes bytes. Un ladrillo solo llega a $limit: usa menos, o guarda los " +
            "valores en un array."

    override fun imageTooLarge(bytes: Int, limit: Int) =
        "Este programa ocupa $bytes bytes en el ladrillo, pero solo hay sitio para $limit. Usa menos clases de " +
            "leJOS, o escribe menos código."

    override fun littleMemory(bytes: Int) =
        "En el ladrillo, este programa solo deja $bytes bytes para objetos, arrays y textos. La memoria puede " +
            "llenarse: escribe menos código, o crea menos."

    override fun largeStep(variable: String, step: Int) =
        "Así el ladrillo solo suma números de -128 a 127. Escribe \"${longForm(variable, step)}\"."

    override fun arraysOfObjectArrays() =
        "El ladrillo no puede crear de una vez arrays de objetos dentro de un array. Crea primero el array de fuera, " +
            "como en \"new String[2][]\", y luego cada array de dentro en un bucle."

    override fun strangeCharacter(character: String) =
        "El ladrillo no conoce el carácter \"$character\". En los textos usa solo letras, cifras y signos sencillos."
}

private object SpanishListingMessages : ListingMessages {
    override fun parts(bytes: Int) = "Una imagen de $bytes bytes:"

    override fun partName(kind: PartKind) = when (kind) {
        PartKind.MASTER_RECORD -> "cabecera"
        PartKind.CLASS_RECORDS -> "registros de clases"
        PartKind.STATIC_STATE -> "valores de los campos static"
        PartKind.STATIC_FIELD_RECORDS -> "registros de campos static"
        PartKind.CONSTANT_RECORDS -> "registros de constantes"
        PartKind.METHOD_RECORDS -> "registros de métodos"
        PartKind.EXCEPTION_RECORDS -> "registros de excepciones"
        PartKind.FIELD_TYPES -> "tipos de los campos"
        PartKind.CODE -> "código"
        PartKind.CONSTANT_VALUES -> "constantes"
        PartKind.ENTRY_CLASSES -> "programas"
    }

    override fun bytesAt(bytes: Int, offset: Int) = "$bytes ${if (bytes == 1) "byte" else "bytes"} desde $offset"

    override fun objectBytes(bytes: Int) = "objetos de $bytes bytes"

    override fun entryClasses() = "Programas:"

    override fun classes() = "Clases y sus métodos:"

    override fun constants() = "Constantes:"

    override fun staticFields() = "Campos static:"

    override fun signatures() = "Firmas:"
}
