plugins {
    id("robotran.jvm-app")
}

dependencies {
    api(project(":shared:language"))
    api(libs.clikt)
}

application {
    mainClass.set("robotran.siteserver.MainKt")
    applicationName = "robotran"
}

kotlin {
    sourceSets {
        test {
            // What commands have said; the tests of the command line use it, too.
            kotlin.srcDir("src/recordingConsole/kotlin")
        }
    }
}
