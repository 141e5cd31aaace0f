plugins {
    id("org.jetbrains.kotlin.jvm")
}

dependencies {
    api(project(":shared:tower"))
    implementation(libs.coroutines.core)
    implementation(libs.jserialcomm)
    testImplementation(kotlin("test"))
    testImplementation(libs.jna)
}

sourceSets {
    // The brick at the other end of the pseudo-terminal.
    test { kotlin.srcDir("../tower/src/simulatedBrick/kotlin") }
}

tasks.withType<Test>().configureEach { useJUnitPlatform() }
