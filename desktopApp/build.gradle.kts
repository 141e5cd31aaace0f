plugins {
    id("robotran.desktop")
}

dependencies {
    implementation(project(":shared:ui"))
    implementation(project(":shared:programs"))
    implementation(project(":shared:projects"))
    implementation(project(":shared:documents"))
    implementation(compose.desktop.currentOs)
    implementation(libs.coroutines.swing)
    implementation(libs.clikt)
    implementation(libs.mordant)
    testImplementation(libs.commons.compress)
    implementation(libs.serialization.json)
    testImplementation(project(":shared:lejos-library"))
}

application {
    mainClass.set("robotran.desktop.MainKt")
    applicationName = "robotran"
}
