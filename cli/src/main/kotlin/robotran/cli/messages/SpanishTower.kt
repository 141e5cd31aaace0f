package robotran.cli.messages

import robotran.language.listed

internal object SpanishTowerMessages : TowerMessages {
    override fun lejosHasNoSlots() =
        "leJOS no tiene espacios para varios programas, el ladrillo guarda solo lo último enviado. Nombra varios " +
            "programas en una orden: el botón Prgm los recorre."

    override fun twoFirmwares() =
        "Estos programas necesitan dos firmwares: .nqc, .lasm y .rcx el de LEGO, los demás leJOS. Un ladrillo solo " +
            "tiene uno de los dos: envíalos en dos órdenes."

    override fun tooFewSlots(first: Int, programs: Int, last: Int) =
        "Desde el espacio $first no hay $programs espacios: el último es el $last. Nombra menos programas u otro " +
            "--slot."

    override fun noTower() =
        "No hay ninguna torre. Conéctala, o di su puerto con --port. En Windows y macOS la torre USB solo " +
            "funciona en la página de Robotran, en Chrome."

    override fun noTowerAt(ports: List<String>) =
        "No hay ninguna torre en ${listed(ports, "ni")}. Conecta la torre y mira si su pila está bien."

    override fun portGone(port: String) = "No existe el puerto $port. Conecta la torre, o di otro puerto con --port."

    override fun portBusy(port: String) = "Otro programa usa $port. Ciérralo y prueba otra vez."

    override fun portNotAllowed(port: String) =
        "No puedes usar $port. En Linux, pide a alguien que pueda que te añada al grupo del archivo, muchas " +
            "veces dialout."

    override fun portHeld(port: String) = "Un controlador del sistema ocupa $port, y Robotran no puede usarlo."

    override fun towerAt(port: String) = "La torre está en $port."

    override fun blocksSent(sent: Int, all: Int, secondsLeft: Int) = "$sent de $all bloques, quedan $secondsLeft s"

    override fun programSent(bytes: Int) = "El ladrillo tiene el programa, $bytes bytes. Pulsa Run."

    override fun programInSlot(bytes: Int, slot: Int) =
        "El ladrillo tiene el programa en el espacio $slot, $bytes bytes. Pulsa Run."

    override fun entriesRead(read: Int, all: Int, secondsLeft: Int) = "$read de $all entradas, quedan $secondsLeft s"

    override fun noDatalog() = "El registro de datos no tiene entradas. Un programa en NQC las hace con AddToDatalog."

    override fun datalogWritten(name: String, entries: Int) =
        "Se ha escrito $name: $entries entradas del registro de datos."

    override fun clockSet(time: String) = "El reloj del ladrillo muestra las $time."

    override fun notATime(text: String) = "$text no es una hora. Escribe horas y minutos, por ejemplo 13:37."

    override fun slotEmptied(slot: Int) = "El espacio $slot del ladrillo está vacío."

    override fun firmwareSent(bytes: Int) = "El ladrillo tiene su firmware, $bytes bytes. Ya puedes enviar programas."

    override fun firmwareIs(name: String, firmware: String) = "$name es $firmware."

    override fun firmwareUnknown(name: String) =
        "$name no es ningún firmware que Robotran conozca. Se envía de todos modos."

    override fun notAFirmware(name: String) =
        "$name no es un firmware. Usa lejos.srec de leJOS, o un archivo de LEGO cuyo nombre termine en .lgo."

    override fun firmwareDamaged(name: String, line: Int) =
        "$name está dañado en la línea $line. Descarga o copia el archivo otra vez."

    override fun firmwareCutOff(name: String) = "$name termina demasiado pronto. Descarga o copia el archivo otra vez."

    override fun firmwareOutOfRange(name: String, line: Int) =
        "$name no es para un RCX: la línea $line es para una memoria que un RCX no tiene."

    override fun firmwareTooLarge(name: String, bytes: Int, limit: Int) =
        "$name es demasiado grande para un RCX: tiene $bytes bytes y pueden ser $limit."

    override fun firmwareForOthers(name: String) =
        "$name no es para un RCX: le falta la frase que un RCX busca antes de iniciar un firmware."

    override fun towerGone() = "La torre se ha desconectado. Conéctala y prueba otra vez."

    override fun towerSilent() =
        "En este puerto no responde nada. Quizá no haya ninguna torre. Si la hay, mira si es su puerto y si su pila " +
            "está bien."

    override fun brickSilent() =
        "El ladrillo no responde. Enciéndelo, para su programa y ponlo delante de la torre, a un palmo."

    override fun noLejos() =
        "El ladrillo no tiene leJOS. Envía primero el firmware de leJOS, con robotran firmware lejos.srec."

    override fun legoInsteadOfLejos(version: String) =
        "Este ladrillo tiene el firmware $version de LEGO, y el programa necesita leJOS. Envía primero el " +
            "firmware de leJOS, con robotran firmware lejos.srec. Para el firmware de LEGO, escribe el programa " +
            "en NQC."

    override fun noLegoFirmware() =
        "Este ladrillo tiene leJOS, o ningún firmware, y esto necesita el de LEGO. Envíalo primero, con " +
            "robotran firmware firm0328.lgo. Si la pantalla muestra un voltaje, el ladrillo tiene leJOS."

    override fun legoFirmwareTooOld(version: String) =
        "Este ladrillo tiene el firmware $version de LEGO, que es el 1.0, y el programa es para el 2.0. Envía el " +
            "firmware 2.0 (firm0328.lgo o posterior), o compila el programa con --target rcx."

    override fun remainsAsBefore() = "El ladrillo tiene lo mismo que antes."

    override fun remainsNoProgram() = "Ahora el ladrillo no tiene programa. Envíalo otra vez."

    override fun remainsEmptySlot(slot: Int) =
        "El espacio $slot del ladrillo está vacío ahora, y los demás siguen como antes. Envía el programa otra vez."

    override fun remainsNoFirmware() = "Ahora el ladrillo no tiene firmware. Envíalo otra vez: no se ha roto nada."

    override fun remainsUnknown() = "Nadie sabe qué tiene ahora el ladrillo. Envíalo otra vez."

    override fun remainsUnknownSlot(slot: Int) =
        "Nadie sabe qué tiene ahora el espacio $slot. Envía el programa otra vez. Los demás espacios siguen como " +
            "antes."

    override fun badConnection() =
        "La torre y el ladrillo se entienden mal. Ponlos más cerca, sin luz fuerte, con buenas pilas y sin otro " +
            "ladrillo al lado."

    override fun batteryLow(volts: String) = "A las pilas solo les quedan $volts V. Pon primero unas nuevas."

    override fun programTooLarge(bytes: Int, limit: Int) =
        "El programa es demasiado grande para el ladrillo: tiene $bytes bytes y pueden ser $limit."

    override fun brickFull(bytes: Int) =
        "El ladrillo no tiene sitio para $bytes bytes más. Vacía espacios que ya no necesites, con robotran " +
            "brick empty 2 3."

    override fun firmwareRefused() = "El ladrillo no inicia este firmware. Usa otro archivo o envíalo otra vez."

    override fun brickHasLejosOrNothing(rom: String) =
        "El ladrillo tiene leJOS, o ningún firmware: los dos responden igual. Si la pantalla muestra un voltaje, " +
            "es leJOS. La ROM es la versión $rom."

    override fun brickHasLego(firmware: String, rom: String) =
        "El ladrillo tiene el firmware $firmware de LEGO. La ROM es la versión $rom."

    override fun batteryIs(volts: String) = "Las pilas tienen $volts V."

    override fun brickIsUnknown() = "Responde un ladrillo, pero no dice qué es."
}
