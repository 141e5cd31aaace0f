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
        System.out.println(animal instanceof Dog ? 1 : 0); // prints: 1
        System.out.println(((Dog) animal).bark()); // prints: 7
        animal = new Animal();
        System.out.println(animal instanceof Dog ? 1 : 0); // prints: 0
        Animal nobody = null;
        System.out.println(nobody instanceof Animal ? 1 : 0); // prints: 0
        System.out.println((Dog) nobody == null ? 1 : 0); // prints: 1
        try {
            ((Dog) animal).bark();
        } catch (ClassCastException notADog) {
            System.out.println(2); // prints: 2
        }
        System.out.println((int) 3.99f); // prints: 3
        System.out.println((int) 'A'); // prints: 65
        System.out.println((int) 5L); // prints: 5
    }
}
