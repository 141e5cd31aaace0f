package robotran.robolang.translate

/** The instructions of a kit for an NXT, in each language. */
internal class NxtKitTexts(private val className: String, private val sourceName: String?) {
    fun readmes(): List<KitFile> = listOf(
        KitFile("$className/README.txt", english()),
        KitFile("$className/LIESMICH.txt", german()),
        KitFile("$className/LEEME.txt", spanish()),
    )

    private fun english(): String {
        val origin = if (sourceName == null) {
            "$className.java is where your Java program begins. It runs"
        } else {
            "$className.java is your Robolang program $sourceName in Java. It runs"
        }
        return """
            $className FOR A REAL ROBOT

            $origin on a LEGO Mindstorms NXT
            with leJOS NXJ 0.9. Plug in what it uses: left wheel on motor A, right wheel on C, pen on B. The
            program says on which port each sensor is.

            ONCE
            1. Install a JDK that leJOS NXJ can use, 6 to 8, and leJOS NXJ 0.9.
            2. Set NXJ_HOME to the folder of leJOS NXJ.
            3. Put the firmware of leJOS NXJ on the brick: nxjflash

            EACH TIME
            Connect the robot by USB, switch it on, and type one of these in this folder:
                ./upload.sh         (Linux, macOS)
                upload.bat          (Windows)
                ant                 (with Ant, on any of them)
            The program starts at once. The brick keeps it: choose it under Files to start it again. Press
            ENTER and ESCAPE together to stop a program that does not end.

            MAKE IT DRIVE AS FAR AS IT SHOULD
            Two figures in $className.java say how your robot is built, if the program has a pilot: the
            diameter of a wheel and the distance between the wheels, in centimetres.

            WHEEL_DIAMETER
            1. Let the robot drive 100 cm with the pen down.
            2. Measure the line in centimetres.
            3. New figure = old figure x what you measured / 100.
               Example: 5.6 and a line of 98 cm make 5.6 x 98 / 100 = 5.49

            TRACK_WIDTH
            1. Let the robot turn 3600 degrees and count how far it turns: ten times round?
            2. New figure = old figure x 3600 / degrees turned.
               Example: 11.4 and 3500 degrees make 11.4 x 3600 / 3500 = 11.73
            """.trimIndent() + "\n"
    }

    private fun german(): String {
        val origin = if (sourceName == null) {
            "Mit $className.java beginnt dein Java-Programm. Es läuft"
        } else {
            "$className.java ist dein Robolang-Programm $sourceName in Java. Es läuft"
        }
        return """
            $className FÜR EINEN ECHTEN ROBOTER

            $origin auf einem LEGO Mindstorms NXT
            mit leJOS NXJ 0.9. Stecke an, was es braucht: linkes Rad an Motor A, rechtes Rad an C, Stift an B.
            Im Programm steht, an welchem Eingang jeder Sensor ist.

            EINMAL
            1. Installiere ein JDK, mit dem leJOS NXJ arbeitet, 6 bis 8, und leJOS NXJ 0.9.
            2. Setze NXJ_HOME auf den Ordner von leJOS NXJ.
            3. Bringe die Firmware von leJOS NXJ auf den Baustein: nxjflash

            JEDES MAL
            Verbinde den Roboter mit USB, schalte ihn ein und tippe in diesem Ordner eines davon:
                ./upload.sh         (Linux, macOS)
                upload.bat          (Windows)
                ant                 (mit Ant, überall)
            Das Programm startet sofort. Der Baustein behält es: Unter Files startest du es wieder. ENTER und
            ESCAPE zusammen beenden ein Programm, das nicht aufhört.

            DAMIT ER SO WEIT FÄHRT, WIE ER SOLL
            Zwei Zahlen in $className.java sagen, wie dein Roboter gebaut ist, wenn das Programm einen Piloten
            hat: der Durchmesser eines Rades und der Abstand der Räder, in Zentimetern.

            WHEEL_DIAMETER
            1. Lass den Roboter mit gesenktem Stift 100 cm fahren.
            2. Miss die Linie in Zentimetern.
            3. Neue Zahl = alte Zahl x gemessene Länge / 100.
               Beispiel: 5.6 und eine Linie von 98 cm ergeben 5.6 x 98 / 100 = 5.49

            TRACK_WIDTH
            1. Lass den Roboter sich um 3600 Grad drehen und zähle mit: zehnmal herum?
            2. Neue Zahl = alte Zahl x 3600 / gedrehte Grad.
               Beispiel: 11.4 und 3500 Grad ergeben 11.4 x 3600 / 3500 = 11.73
            """.trimIndent() + "\n"
    }

    private fun spanish(): String {
        val origin = if (sourceName == null) {
            "En $className.java empieza tu programa en Java. Funciona"
        } else {
            "$className.java es tu programa en Robolang $sourceName en Java. Funciona"
        }
        return """
            $className PARA UN ROBOT DE VERDAD

            $origin en un LEGO Mindstorms NXT
            con leJOS NXJ 0.9. Conecta lo que usa: rueda izquierda en el motor A, rueda derecha en C, lápiz en B.
            El programa dice en qué puerto está cada sensor.

            UNA VEZ
            1. Instala un JDK que sirva para leJOS NXJ, de 6 a 8, y leJOS NXJ 0.9.
            2. Pon en NXJ_HOME la carpeta de leJOS NXJ.
            3. Pasa el firmware de leJOS NXJ al ladrillo: nxjflash

            CADA VEZ
            Conecta el robot por USB, enciéndelo y escribe en esta carpeta una de estas líneas:
                ./upload.sh         (Linux, macOS)
                upload.bat          (Windows)
                ant                 (con Ant, en todos)
            El programa empieza enseguida. El ladrillo lo guarda: elígelo en Files para empezarlo otra vez. ENTER
            y ESCAPE a la vez paran un programa que no termina.

            PARA QUE AVANCE LO QUE DEBE
            Dos números en $className.java dicen cómo es tu robot, si el programa tiene un piloto: el diámetro
            de una rueda y la distancia entre las ruedas, en centímetros.

            WHEEL_DIAMETER
            1. Haz que el robot avance 100 cm con el lápiz bajado.
            2. Mide la línea en centímetros.
            3. Número nuevo = número viejo x lo que mides / 100.
               Ejemplo: 5.6 y una línea de 98 cm dan 5.6 x 98 / 100 = 5.49

            TRACK_WIDTH
            1. Haz que el robot gire 3600 grados y cuenta cuánto gira: ¿diez vueltas?
            2. Número nuevo = número viejo x 3600 / grados girados.
               Ejemplo: 11.4 y 3500 grados dan 11.4 x 3600 / 3500 = 11.73
            """.trimIndent() + "\n"
    }
}
