package robotran.robolang.translate

/** The texts of a kit's files other than the program. */
internal object KitTexts {
    fun readme(className: String, sourceName: String): String =
        """
        $className FOR A REAL ROBOT

        $className.java is your Robolang program $sourceName in Java. It runs on a LEGO Mindstorms RCX
        with leJOS 2.1 or 3.0: left wheel on motor A, right wheel on C, pen on B, bumpers on 1 (left)
        and 3 (right), light sensor on 2 unless your program names another.

        @STEPS@

        MAKE IT DRIVE AS FAR AS IT SHOULD
        No two robots are quite alike, and a fresh battery makes them faster. Two figures at the top
        of $className.java say how fast yours is. They are there if the program drives or turns.

        MILLISECONDS_PER_CENTIMETRE
        1. Run a program with the two lines  pen down  and  forward 100
        2. Measure the line in centimetres.
        3. New figure = old figure x 100 / what you measured.
           Example: 50 and a line of 80 cm make 50 x 100 / 80 = 62.5

        MILLISECONDS_PER_DEGREE
        1. Run a program with the line  turn left 360  and mark where the robot looks before and after.
        2. Measure how many degrees it really turned: more than 360 if it went past the first mark.
           Ten turns in one,  turn left 3600 , tell it better: divide what you measure by ten.
        3. New figure = old figure x 360 / degrees turned.
           Example: 5 and 324 degrees make 5 x 360 / 324 = 5.56

        To change a figure, open $className.java in an editor, write the new one in the place of the old
        with an f behind it, such as 62.5f, save the file and download again.
        """.trimIndent().replace("@STEPS@", steps(className)) + "\n"

    /** The instructions for a program written in Java. */
    fun javaReadme(className: String): String =
        """
        $className FOR A REAL ROBOT

        $className.java is where your Java program begins. It runs on a LEGO Mindstorms RCX with leJOS
        2.1 or 3.0. Plug motors and sensors in where it wants them: the robot of Robotran has its left
        wheel on motor A, the right wheel on C, the pen on B, bumpers on 1 (left) and 3 (right) and the
        light sensor on 2.

        @STEPS@

        IF IT DRIVES FARTHER OR LESS FAR THAN IN ROBOTRAN
        No two robots are quite alike, and a fresh battery makes them faster. Measure how far yours
        goes, and change the times in your program by the same share.
        """.trimIndent().replace("@STEPS@", steps(className)) + "\n"

    /** How to send the program: Robotran's own way first, then leJOS's tools. */
    private fun steps(className: String): String =
        """
        THE EASY WAY: ROBOTRAN SENDS IT
        Open your program in Robotran and choose "Send to my robot", or type
            robotran send $className.java
        You need an infrared tower, and the firmware of leJOS on the brick. Robotran says what is missing
        and how to get it. It needs nothing else of this folder.

        THE OLD WAY: THE TOOLS OF LEJOS, ONCE
        1. Install a JDK that leJOS can use, 1.4 to 8, and leJOS 2.1 or 3.0.
        2. Set LEJOS_HOME to the folder of leJOS and RCXTTY to the infrared tower: usb or COM1.
        3. Put the robot before the tower, about 10 cm away, and switch it on.
        4. Put the firmware of leJOS on the brick: lejosfirmdl (leJOS 2.1) or firmdl (leJOS 3.0)

        THE OLD WAY, EACH TIME
        Switch the robot on and type one of these in this folder:
            ./download.sh       (Linux, macOS)
            download.bat        (Windows)
            ant                 (with Ant, on any of them)
        Then press Run on the brick. Hold Run and press On-Off to stop a program that does not end.
        """.trimIndent()
}
