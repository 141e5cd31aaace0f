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
        System.out.println(animal instanceof Dog ? 1 : 0); // expect 1
        System.out.println(((Dog) animal).bark()); // expect 7
        animal = new Animal();
        System.out.println(animal instanceof Dog ? 1 : 0); // expect 0
        Animal nobody = null;
        System.out.println(nobody instanceof Animal ? 1 : 0); // expect 0
        System.out.println((Dog) nobody == null ? 1 : 0); // expect 1
        try {
            ((Dog) animal).bark();
        } catch (ClassCastException notADog) {
            System.out.println(2); // expect 2
        }
        System.out.println((int) 3.99f); // expect 3
        System.out.println((int) 'A'); // expect 65
        System.out.println((int) 5L); // expect 5
    }
}
