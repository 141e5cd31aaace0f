plugins {
    id("robotran.desktop")
}

dependencies {
    implementation(project(":cli"))
    implementation(project(":shared:ui"))
    implementation(project(":shared:desktop-tower"))
    implementation(compose.desktop.currentOs)
    implementation(libs.coroutines.swing)
}

application {
    mainClass.set("robotran.desktop.MainKt")
    applicationName = "robotran"
}
