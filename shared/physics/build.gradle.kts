plugins {
    id("robotran.physics")
}
