package robotran.robolang.translate

/**
 * The files that bring a program for an NXT onto a real one with the tools of leJOS NXJ 0.9.
 *
 * @param className its main class, without package; also the name of the program on the brick.
 * @param sourceName the Robolang program that it is a translation of; null if it was written in Java.
 * @param mainClass the main class with its package.
 * @param javaFiles the names of its sources, without characters that are special to a shell.
 */
internal class NxtKit(
    private val className: String,
    private val sourceName: String?,
    private val mainClass: String = className,
    javaFiles: List<String> = listOf("$className.java"),
) {
    private val sources = javaFiles.joinToString(" ")

    fun files(): List<KitFile> = listOf(
        KitFile("$className/README.txt", if (sourceName == null) javaReadme() else readme()),
        KitFile("$className/build.xml", antFile()),
        KitFile("$className/upload.sh", shellScript(), isExecutable = true),
        KitFile("$className/upload.bat", batchFile().replace("\n", "\r\n")),
    )

    private fun readme(): String =
        """
        $className FOR A REAL ROBOT

        $className.java is your Robolang program $sourceName in Java. It runs on a LEGO Mindstorms NXT
        with leJOS NXJ 0.9. Plug in what it uses: left wheel on motor A, right wheel on C, pen on B. The
        lines at the top of $className.java say on which port each sensor is.

        @STEPS@

        MAKE IT DRIVE AS FAR AS IT SHOULD
        Two figures at the top of $className.java say how your robot is built. They are there if the
        program drives or turns.

        WHEEL_DIAMETER
        1. Run a program with the two lines  pen down  and  forward 100
        2. Measure the line in centimetres.
        3. New figure = old figure x what you measured / 100.
           Example: 5.6 and a line of 98 cm make 5.6 x 98 / 100 = 5.49

        TRACK_WIDTH
        1. Run a program with the line  turn left 3600  and count how far it turns: ten times round?
        2. New figure = old figure x 3600 / degrees turned.
           Example: 11.4 and 3500 degrees make 11.4 x 3600 / 3500 = 11.73
        """.trimIndent().replace("@STEPS@", steps()) + "\n"

    /** The instructions for a program written in Java. */
    private fun javaReadme(): String =
        """
        $className FOR A REAL ROBOT

        $className.java is where your Java program begins. It runs on a LEGO Mindstorms NXT with leJOS
        NXJ 0.9. Plug motors and sensors in where it wants them: the penbot of Robotran has its left
        wheel on motor A, the right wheel on C and the pen on B.

        @STEPS@

        IF IT DRIVES FARTHER OR LESS FAR THAN IN ROBOTRAN
        Measure the wheels of your robot and how far they are apart, and write what you have measured
        where the program makes its pilot.
        """.trimIndent().replace("@STEPS@", steps()) + "\n"

    private fun steps(): String =
        """
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
        """.trimIndent()

    private fun antFile(): String =
        """
        <?xml version="1.0" encoding="UTF-8"?>
        <project name="$className" default="upload" basedir=".">
            <property environment="env"/>
            <property name="nxj.bin" location="${'$'}{env.NXJ_HOME}/bin"/>

            <macrodef name="nxj">
                <attribute name="tool"/>
                <attribute name="line"/>
                <sequential>
                    <exec executable="${'$'}{nxj.bin}/@{tool}" osfamily="unix" failonerror="true">
                        <arg line="@{line}"/>
                    </exec>
                    <exec executable="cmd" osfamily="windows" failonerror="true">
                        <arg value="/c"/>
                        <arg value="${'$'}{nxj.bin}\@{tool}"/>
                        <arg line="@{line}"/>
                    </exec>
                </sequential>
            </macrodef>

            <target name="link" description="compiles and links the program">
                <nxj tool="nxjc" line="-encoding UTF-8 -d . $sources"/>
                <nxj tool="nxjlink" line="-o $className.nxj $mainClass"/>
            </target>

            <target name="upload" depends="link" description="sends it to the brick and starts it">
                <nxj tool="nxjupload" line="-r $className.nxj"/>
            </target>
        </project>
        """.trimIndent() + "\n"

    private fun shellScript(): String =
        """
        #!/bin/sh
        # Compiles $className for the brick and sends it there with leJOS NXJ's own tools.
        set -e
        cd "${'$'}(dirname "${'$'}0")"
        PATH="${'$'}{NXJ_HOME:+${'$'}NXJ_HOME/bin:}${'$'}PATH"
        if ! command -v nxjc > /dev/null; then
            echo "leJOS NXJ is not there: set NXJ_HOME to its folder. README.txt says more." >&2
            exit 1
        fi
        nxjc -encoding UTF-8 -d . $sources
        nxjlink -o $className.nxj $mainClass
        nxjupload -r $className.nxj
        """.trimIndent() + "\n"

    private fun batchFile(): String =
        """
        @echo off
        rem Compiles $className for the brick and sends it there with leJOS NXJ's own tools.
        cd /d "%~dp0"
        if not "%NXJ_HOME%"=="" set PATH=%NXJ_HOME%\bin;%PATH%
        where nxjc >nul 2>nul || (
            echo leJOS NXJ is not there: set NXJ_HOME to its folder. README.txt says more.
            exit /b 1
        )
        call nxjc -encoding UTF-8 -d . $sources || exit /b 1
        call nxjlink -o $className.nxj $mainClass || exit /b 1
        call nxjupload -r $className.nxj
        """.trimIndent() + "\n"
}
