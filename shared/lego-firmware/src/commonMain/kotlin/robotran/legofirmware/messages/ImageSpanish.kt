package robotran.legofirmware.messages

import robotran.language.quoted

internal object ImageSpanish : ImageMessages {
    override fun tooLarge(bytes: Int, limit: Int) =
        "Este archivo tiene $bytes bytes. Un programa para el RCX nunca tiene más de $limit bytes."

    override fun notAnImage() =
        "Este no es un archivo de programa del RCX. Empieza con las letras RCXI y lo hace un compilador de NQC."

    override fun newerVersion(version: String) =
        "Este archivo tiene la versión de formato $version. Robotran lee versiones hasta la 1.02."

    override fun otherBrick(name: String?) = if (name == null) {
        "Este programa es para un ladrillo desconocido."
    } else {
        "Este programa es para el ladrillo $name, no para un RCX."
    }

    override fun unknownChunk(type: Int) =
        "El archivo tiene una parte de tipo desconocido ($type). Solo se permiten tareas y subrutinas."

    override fun chunkCut(chunk: String?) =
        "El archivo termina en medio de ${chunk?.let { "la $it" } ?: "una parte"}. ¿Se copió completo?"

    override fun numberTooHigh(isTask: Boolean, number: Int, highest: Int) =
        "El archivo tiene la ${chunk(isTask, number)}, pero el número más alto es $highest."

    override fun chunkTwice(chunk: String) = "El archivo tiene dos veces la $chunk."

    override fun tooManySymbols(count: Int, limit: Int) =
        "El archivo tiene $count nombres. Se permiten como máximo $limit."

    override fun namesCut(missing: Int) = if (missing == 1) {
        "El archivo termina demasiado pronto. Falta un nombre, pero el programa puede funcionar."
    } else {
        "El archivo termina demasiado pronto. Faltan $missing nombres, pero el programa puede funcionar."
    }

    override fun nameWithoutChunk(name: String) = "El nombre ${quoted(name)} no pertenece a nada en este archivo."

    override fun extraBytes(bytes: Int) = "Al final del archivo sobran $bytes bytes. No se usan."

    override fun largeProgram(bytes: Int, limit: Int) =
        "El programa tiene $bytes bytes. Un RCX real tiene sitio para unos $limit, para todos los programas juntos."

    override fun noMainTask() = "El programa no tiene la tarea 0. Por eso el botón Run no inicia nada."

    override fun chunk(isTask: Boolean, number: Int) = if (isTask) "tarea $number" else "subrutina $number"
}
