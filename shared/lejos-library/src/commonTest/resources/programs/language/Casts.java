import josx.platform.rcx.LCD;

public class Casts {
    static class Animal {
    }

    static class Dog extends Animal {
        int bark() {
            return 7;
        }
    }

    public static void main(String[] arguments) {
        Animal animal = new Dog();
        LCD.showNumber(animal instanceof Dog ? 1 : 0); // shows: 1
        LCD.showNumber(((Dog) animal).bark()); // shows: 7
        animal = new Animal();
        LCD.showNumber(animal instanceof Dog ? 1 : 0); // shows: 0
        Animal nobody = null;
        LCD.showNumber(nobody instanceof Animal ? 1 : 0); // shows: 0
        LCD.showNumber((Dog) nobody == null ? 1 : 0); // shows: 1
        try {
            ((Dog) animal).bark();
        } catch (ClassCastException notADog) {
            LCD.showNumber(2); // shows: 2
        }
        LCD.showNumber((int) 3.99f); // shows: 3
        LCD.showNumber((int) 'A'); // shows: 65
        LCD.showNumber((int) 5L); // shows: 5
    }
}
