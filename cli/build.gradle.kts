plugins {
    id("robotran.jvm-app")
}

dependencies {
    implementation(project(":shared:programs"))
    api(project(":shared:projects"))
    implementation(project(":shared:documents"))
    implementation(libs.coroutines.core)
    implementation(libs.clikt)
    implementation(libs.mordant)
    implementation(libs.serialization.json)
    testImplementation(libs.commons.compress)
    testImplementation(project(":shared:lejos-library"))
}

application {
    mainClass.set("robotran.cli.MainKt")
    applicationName = "robotran"
}
