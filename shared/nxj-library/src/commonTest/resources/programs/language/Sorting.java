public class Sorting {
    static void sort(int[] numbers) {
        for (int last = numbers.length - 1; last > 0; last--) {
            for (int index = 0; index < last; index++) {
                if (numbers[index] > numbers[index + 1]) {
                    int larger = numbers[index];
                    numbers[index] = numbers[index + 1];
                    numbers[index + 1] = larger;
                }
            }
        }
    }

    public static void main(String[] arguments) {
        int[] numbers = {5, 2, 9, 1, 7};
        sort(numbers);
        for (int index = 0; index < numbers.length; index++) System.out.println(numbers[index]); // expect 1
        // expect 2
        // expect 5
        // expect 7
        // expect 9
    }
}
